"""The whole protocol of a comparison: systems on scenarios at seeds, from plan to report.

`run` tries every `System` on every `Scenario` at every seed and logs what happens, `evaluate`
measures the logs, `compare` says which differences are more than chance, `report` writes a page
that somebody else can check. `adopt` makes the logs out of recordings that are there already.
`scenarios` and `systems` are a benchmark to begin with.

**One trial, one process.** A trial runs in a new process, in a folder that is thrown away, with
one thread in linear algebra and fixed seeds of everything global. What that keeps out of the
others and of the results depends on the operating system:

======================================  =====  =====  =======
What a system does                      Linux  macOS  Windows
======================================  =====  =====  =======
raises, exits, crashes                  yes    yes    yes
returns NaN or no estimate              yes    yes    yes
changes global state, prints a lot      yes    yes    yes
runs longer than ``time_limit``         yes    yes    yes
takes more than ``memory_limit``        yes    (a)    no
leaves processes behind                 yes    (b)    (c)
======================================  =====  =====  =======

(a) The operating system may not enforce it. (b) Those of its own process group are ended, not one
that moved to a session of its own. (c) They are ended after the time limit only. The limit of
memory holds for each process of a trial, not for their sum. Nowhere is a system kept from reading
or writing files on purpose: for code that you do not trust, use a machine of its own.

**Killed, and on again.** Each trial is written by one rename, so that it is there as a whole or
not at all. After ``kill -9``, a power cut or a full disk the same call of `run` goes on where it
stopped. ``protocol.json`` pins down what was decided; `run` refuses a folder that was begun
otherwise.

**Many machines.** `run` takes any `concurrent.futures.Executor`. On each machine the same versions
are installed; nothing else is shared, no folder either, for only the process that calls `run`
writes. With Dask::

    dask scheduler --port 8786                 # on one machine
    dask worker tcp://ADDRESS:8786             # on each machine

    from distributed import Client
    with Client("tcp://ADDRESS:8786") as client:
        am.benchmark.run(systems, scenarios, 20, "logs", client.get_executor())

Examples
--------
>>> import tempfile
>>> import numpy as np
>>> import amrmetrics as am
>>> def stand_still(log):
...     return am.benchmark.Estimate(np.tile(np.eye(3), (len(log.stamps), 1, 1)))
>>> system = am.benchmark.System("stand_still", stand_still)
>>> folder = tempfile.mkdtemp()
>>> run = am.benchmark.run(system, am.benchmark.scenarios()[0], 1, folder, progress=False)
>>> run.trials, run.failed
(1, 0)
"""

import lazy_loader as _lazy

__getattr__, __dir__, __all__ = _lazy.attach_stub(__name__, __file__)
