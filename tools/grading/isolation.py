"""Put the calling process, before any code of a student runs, where it can do no harm.

`LEVELS` names what there is, best first. A process is in namespaces of its own: of files (the
system and the Python environment, read-only, and a small folder in memory), of processes, of
the network (there is none). Where the system allows none of this, it is another user (if the
grader is root), and in any case it has limits.
"""

import contextlib
import ctypes
import os
import pathlib
import signal
import sys

LEVELS = {
    "namespaces": "no network, no files but the system's, no other processes, limits",
    "another user": "a user without rights, and limits; network and readable files are open",
    "limits": "limits of time, memory, processes and files only: a submission could read and "
    "change what you can",
    "time": "a limit of time only: a submission could read and change what you can",
}
NEW_FILES, NEW_USER, NEW_PROCESSES, NEW_NETWORK = 0x20000, 0x10000000, 0x20000000, 0x40000000
NEW_IPC, NEW_NAME = 0x08000000, 0x04000000
READ_ONLY, NO_SET_UID, NO_DEVICES, NO_EXECUTION = 1, 2, 4, 8
REMOUNT, BIND, RECURSIVE, PRIVATE = 32, 4096, 16384, 1 << 18
FIRST_USER = 58_000  # of users that own nothing
SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/nix/store", "/opt")
SETTINGS = ("ld.so.cache", "ld.so.conf", "ld.so.conf.d", "alternatives", "fonts", "localtime")
DEVICES = ("null", "zero", "random", "urandom", "full")
HOME = "/home/student"
DISK = 64 << 20  # bytes
FILES = 4096


def libc():
    return ctypes.CDLL(None, use_errno=True)


def call(name, *arguments):
    arguments = [a.encode() if isinstance(a, str) else a for a in arguments]
    if getattr(libc(), name)(*arguments):
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")


def separate():
    """Leave the namespaces of the grader; the next child is the first process of its own.

    Returns the level that was reached. Everything else is done by `enclose` in the child.
    """
    if sys.platform != "linux":
        return plain_level()
    flags = NEW_FILES | NEW_PROCESSES | NEW_NETWORK | NEW_IPC | NEW_NAME
    user, group = os.geteuid(), os.getegid()
    with contextlib.suppress(OSError, AttributeError):
        if user != 0:
            call("unshare", flags | NEW_USER)
            pathlib.Path("/proc/self/setgroups").write_text("deny")
            pathlib.Path("/proc/self/uid_map").write_text(f"1000 {user} 1")
            pathlib.Path("/proc/self/gid_map").write_text(f"1000 {group} 1")
        else:
            call("unshare", flags)
        return "namespaces"
    return plain_level()


def plain_level():
    if not hasattr(os, "fork"):
        return "time"
    return "another user" if os.geteuid() == 0 else "limits"


def enclose(level, order):
    """Finish in the student's process what `separate` began, and give up every right."""
    data = {p.name: p.read_bytes() for p in pathlib.Path(order["data"]).iterdir() if p.is_file()}
    others = running()
    home = HOME if level == "namespaces" else order["home"]
    if level == "namespaces":
        new_root(order["root"], order["hidden"])
    pathlib.Path(home).mkdir(parents=True, exist_ok=True)
    os.chdir(home)
    for name, content in data.items():
        pathlib.Path(name).write_bytes(content)
    user = order["user"]
    if os.name == "posix" and os.geteuid() == 0:
        for path in (home, *data):
            os.chown(path, user, user)
        with contextlib.suppress(OSError):
            os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
    elif level == "namespaces":
        drop_capabilities()
    os.environ.clear()
    os.environ |= {"HOME": home, "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "MPLBACKEND": "Agg"}
    os.environ |= {"TMPDIR": home, "MPLCONFIGDIR": home, "OPENBLAS_NUM_THREADS": "1"}
    limit(order["limits"], others)


def new_root(root, hidden):
    call("mount", "none", "/", None, RECURSIVE | PRIVATE, None)
    size = f"size={DISK},nr_inodes={FILES},mode=755"
    call("mount", "tmpfs", root, "tmpfs", NO_SET_UID | NO_DEVICES, size)
    for path in (*SYSTEM, *(f"/etc/{name}" for name in SETTINGS), *(f"/dev/{d}" for d in DEVICES)):
        show(root, path)
    for path in {sys.prefix, sys.base_prefix}:
        show(root, path)
    for path in hidden:
        if os.path.isdir(root + path):
            call("mount", "tmpfs", root + path, "tmpfs", NO_SET_UID | NO_DEVICES, "size=64k")
            for prefix in {sys.prefix, sys.base_prefix}:
                if pathlib.Path(prefix).is_relative_to(path):
                    show(root, prefix)
    for path in ("/proc", "/dev/shm", "/tmp"):
        os.makedirs(root + path, exist_ok=True)
    for path in ("/dev/shm", "/tmp"):
        os.chmod(root + path, 0o1777)
    with contextlib.suppress(OSError):  # a container may refuse it
        call("mount", "proc", root + "/proc", "proc", NO_SET_UID | NO_DEVICES | NO_EXECUTION, None)
    os.chdir(root)
    os.chroot(".")
    os.chdir("/")


def show(root, path):
    """Let a file or folder of the system be seen read-only under the same name."""
    if not os.path.exists(path) or os.path.lexists(root + path):
        return
    if os.path.islink(path) and os.path.dirname(path) == "/":
        os.symlink(os.readlink(path), root + path)
        return
    if os.path.isdir(path):
        os.makedirs(root + path, exist_ok=True)
    else:
        os.makedirs(os.path.dirname(root + path), exist_ok=True)
        pathlib.Path(root + path).touch()
    source = os.path.realpath(path)
    device = path.startswith("/dev/")
    try:
        call("mount", source, root + path, None, BIND, None)
    except OSError:
        call("mount", source, root + path, None, BIND | RECURSIVE, None)
    locked = os.statvfs(root + path).f_flag & (NO_SET_UID | NO_DEVICES | NO_EXECUTION)
    flags = BIND | REMOUNT | READ_ONLY | NO_SET_UID | (0 if device else NO_DEVICES)
    call("mount", None, root + path, None, flags | locked, None)


def drop_capabilities():
    """Give up what the first process of a user namespace may do in it."""
    header = (ctypes.c_uint32 * 2)(0x20080522, 0)
    call("capset", ctypes.byref(header), ctypes.byref((ctypes.c_uint32 * 6)()))
    with contextlib.suppress(OSError):
        call("prctl", 38, 1, 0, 0, 0)  # no new privileges


def running():
    """Return how many processes this user has besides: a limit of processes counts them, too."""
    user = os.geteuid()
    if user == 0:  # it will be another user
        return 0
    try:
        mine = [p for p in os.scandir("/proc") if p.name.isdigit() and p.stat().st_uid == user]
        return sum(len(os.listdir(f"/proc/{p.name}/task")) for p in mine)
    except OSError:  # macOS has no such folder, and processes come and go
        return 500


def end_all(user):
    """End every process of a user who owns nothing else; only root can."""
    pid = os.fork()
    if pid == 0:
        with contextlib.suppress(OSError):
            os.setresuid(user, user, user)
            os.kill(-1, signal.SIGKILL)
        os._exit(0)
    os.waitpid(pid, 0)


def limit(limits, others=0):
    """Hold this process and its children to memory, processes, open files and computing time."""
    try:
        import resource
    except ImportError:
        return
    used = 0
    with contextlib.suppress(OSError):
        pages = int(pathlib.Path("/proc/self/statm").read_text().split()[0])
        used = pages * os.sysconf("SC_PAGE_SIZE")
    wanted = {
        "RLIMIT_AS": used + limits["memory"],
        "RLIMIT_NPROC": limits["processes"] + others,
        "RLIMIT_NOFILE": 128,
        "RLIMIT_FSIZE": DISK,
        "RLIMIT_CPU": limits["seconds"],
        "RLIMIT_CORE": 0,
    }
    for name, value in wanted.items():
        kind = getattr(resource, name, None)
        if kind is not None:
            hard = resource.getrlimit(kind)[1]
            if hard != resource.RLIM_INFINITY:
                value = min(value, hard)
            with contextlib.suppress(ValueError, OSError):
                resource.setrlimit(kind, (value, value))


def limit_checker(memory):
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
