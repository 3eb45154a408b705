# %% wrong: the P99 in seconds
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the warm-up in the P99
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile((log["end_s"] - log["start_s"])[log["robot"] == k], 99) for k in (0, 1)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the P99 from the image
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["image_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the P99 of the processor
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["cpu_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the P95
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 95) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: mean plus 2.33 sigma
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * ((r["end_s"] - r["start_s"]).mean() + 2.33*(r["end_s"] - r["start_s"]).std()) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the longest
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * (r["end_s"] - r["start_s"]).max() for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: both robots together
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = 1000 * np.percentile(warm["end_s"] - warm["start_s"], 99)
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: rows only
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] > 0.1) for r in (A, B)]
better = "A"

# %% wrong: computing times only
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["start_s"] > 0.1) for r in (A, B)]
better = "A"

# %% wrong: computing times and dropped images
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["start_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: late by the processor
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["cpu_s"] > 0.1) for r in (A, B)]
better = "A"

# %% wrong: dropped only
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - len(r) for r in (A, B)]
better = "B"

# %% wrong: the warm-up among the late ones
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1200 - np.sum(log["end_s"][log["robot"] == k] - log["image_s"][log["robot"] == k] <= 0.1) for k in (0, 1)]
better = "B"

# %% wrong: the warm-up among the late rows
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(log["end_s"][log["robot"] == k] - log["image_s"][log["robot"] == k] > 0.1) for k in (0, 1)]
better = "B"

# %% wrong: each gap once
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] > 0.1) + np.sum(np.diff(r["image_s"]) > 0.15) for r in (A, B)]
better = "B"

# %% wrong: mended by the expected interval
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [sum(len(np.arange(t, 0.1, -0.1)) for t in r["end_s"] - r["start_s"]) for r in (A, B)]
better = "B"

# %% wrong: those in time
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: shares
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1 - np.sum(r["end_s"] - r["image_s"] <= 0.1) / 1150 for r in (A, B)]
better = "B"

# %% wrong: one image too many
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1151 - len(r) for r in (A, B)]
late = [1151 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the robots swapped
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)][::-1]
better = "B"

# %% wrong: late with one number
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = 102
better = "B"

# %% wrong: gaps for dropped images
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [np.sum(np.diff(r["image_s"]) > 0.15) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the warm-up among the dropped
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1200 - np.sum(log["robot"] == k) for k in (0, 1)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the warm-up taken off the rows only
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1200 - len(r) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the warm-up taken off the images only
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - np.sum(log["robot"] == k) for k in (0, 1)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: 50 rows are left out
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
A, B = (log[log["robot"] == k][50:] for k in (0, 1))
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: one image is missing
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1149 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: a deadline of 100 s
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] > 100) for r in (A, B)]
better = "B"

# %% wrong: nothing was dropped
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [0, 0]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: the rows
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [len(r) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: one dropped too many
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1151 - len(r) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "B"

# %% wrong: A, by the P99
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "A"

# %% wrong: a number for the robot
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = 1

# %% wrong: both
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "A and B"

# %% wrong: no robot
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = ...

# %% right: with the library and masks
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * am.latency(r["end_s"] - r["start_s"]).p99 for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = np.array([1150 - (r["end_s"] - r["image_s"] < 0.1).sum() for r in (A, B)])
better = "b"

# %% right: rounded P99, tuples
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = (38.7, 79.7)
dropped = (94, 0)
late = (102, 54)
better = "B"

# %% right: whole milliseconds
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = (39, 80)
dropped = [1150 - len(A), 1150 - len(B)]
late = [102.0, 54.0]
better = "B"

# %% right: an order statistic
log = np.genfromtxt("frames.csv", delimiter=",", names=True)
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.sort(r["end_s"] - r["start_s"])[int(np.ceil(0.99 * len(r))) - 1] for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [(1150 - len(r)) + np.sum(r["end_s"] - r["image_s"] >= 0.1) for r in (A, B)]
better = "B"

# %% right: loops over the due images, plain Python
import csv

with open("frames.csv", encoding="utf-8") as file:
    rows = list(csv.DictReader(file))
late, dropped, p99 = [], [], []
for robot in ("0", "1"):
    pose = {round(float(r["image_s"]) * 10): float(r["end_s"]) for r in rows if r["robot"] == robot}
    due = range(50, 1200)
    dropped.append(sum(k not in pose for k in due))
    late.append(sum(pose.get(k, 1e9) - k / 10 > 0.1 for k in due))
    taken = sorted(
        1000 * (float(r["end_s"]) - float(r["start_s"]))
        for r in rows
        if r["robot"] == robot and float(r["image_s"]) > 4.99
    )
    p99.append(taken[int(0.99 * len(taken))])
better = "AB"[late.index(min(late))]

# %% right: loadtxt, rows by number
x = np.loadtxt("frames.csv", delimiter=",", skiprows=1)
x = x[x[:, 1] > 4.95]
p99 = 1000 * np.array([np.percentile((x[:, 3] - x[:, 2])[x[:, 0] == k], 99) for k in (0, 1)])
dropped = [int(1150 - (x[:, 0] == k).sum()) for k in (0, 1)]
late = [int(dropped[k] + ((x[:, 3] - x[:, 1])[x[:, 0] == k] > 0.1).sum()) for k in (0, 1)]
better = str(np.array(["A", "B"])[np.argmin(late)])
