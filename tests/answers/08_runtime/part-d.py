# %% wrong: the P99 in seconds
# says: you give seconds
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the warm-up in the P99
# says: the warm-up is counted
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile((log["end_s"] - log["start_s"])[log["robot"] == k], 99) for k in (0, 1)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the P99 from the image
# says: you started the clock at the image; that comes next
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["image_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the P99 of the processor
# says: this is processor time
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["cpu_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the P95
# says: this is the P95
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 95) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: mean plus 2.33 sigma
# says: this is the mean plus 2.33 standard deviations
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * ((r["end_s"] - r["start_s"]).mean() + 2.33*(r["end_s"] - r["start_s"]).std()) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the longest
# says: this is the longest time
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * (r["end_s"] - r["start_s"]).max() for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: both robots together
# says: p99: shape (2,) is asked, you have 77.77.
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = 1000 * np.percentile(warm["end_s"] - warm["start_s"], 99)
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: rows only
# says: you count only images that have a row
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] > 0.1) for r in (A, B)]
better = "A"

# %% wrong: computing times only
# says: you start the clock when the computing starts
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["start_s"] > 0.1) for r in (A, B)]
better = "A"

# %% wrong: computing times and dropped images
# says: you count dropped images, and start the clock with the computing
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["start_s"] <= 0.1) for r in (A, B)]

# %% wrong: late by the processor
# says: this is processor time, or a deadline of 100 s
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["cpu_s"] > 0.1) for r in (A, B)]
better = "A"

# %% wrong: dropped only
# says: you count only the images without a row
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - len(r) for r in (A, B)]

# %% wrong: the warm-up among the late ones
# says: the warm-up is counted
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1200 - np.sum(log["end_s"][log["robot"] == k] - log["image_s"][log["robot"] == k] <= 0.1) for k in (0, 1)]

# %% wrong: the warm-up among the late rows
# says: the warm-up is counted, and images without a row are not
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(log["end_s"][log["robot"] == k] - log["image_s"][log["robot"] == k] > 0.1) for k in (0, 1)]

# %% wrong: each gap once
# says: you count each gap once, however many images it swallows
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] > 0.1) + np.sum(np.diff(r["image_s"]) > 0.15) for r in (A, B)]

# %% wrong: mended by the expected interval
# says: you mended the computing times; here the stamps tell more
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [sum(len(np.arange(t, 0.1, -0.1)) for t in r["end_s"] - r["start_s"]) for r in (A, B)]

# %% wrong: those in time
# says: you count the images that were in time
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: shares
# says: you give shares
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1 - np.sum(r["end_s"] - r["image_s"] <= 0.1) / 1150 for r in (A, B)]

# %% wrong: one image too many
# says: you count an image at 120 s, or lost the row of 5 s
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1151 - len(r) for r in (A, B)]
late = [1151 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the robots swapped
# says: the robots are swapped
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)][::-1]

# %% wrong: late with one number
# says: late: shape (2,) is asked, you have 102.
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = 102

# %% wrong: gaps for dropped images
# says: you count gaps, not images
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [np.sum(np.diff(r["image_s"]) > 0.15) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the warm-up among the dropped
# says: you count the warm-up, or left out 50 rows, not 50 images
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1200 - np.sum(log["robot"] == k) for k in (0, 1)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the warm-up taken off the rows only
# says: you took the warm-up off the rows, and not off the images
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1200 - len(r) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the warm-up taken off the images only
# says: you took the warm-up off the images, and not off the rows
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - np.sum(log["robot"] == k) for k in (0, 1)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: 50 rows are left out
# says: you left out 50 rows, not 50 images
A, B = (log[log["robot"] == k][50:] for k in (0, 1))
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: one image is missing
# says: you miss one of the images after the warm-up
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1149 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: a deadline of 100 s
# says: this is processor time, or a deadline of 100 s
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [np.sum(r["end_s"] - r["image_s"] > 100) for r in (A, B)]

# %% wrong: nothing was dropped
# says: dropped: [0, 0] is not right.
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [0, 0]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: the rows
# says: these are the rows
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [len(r) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: one dropped too many
# says: you count an image at 120 s, or lost the row of 5 s
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1151 - len(r) for r in (A, B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]

# %% wrong: A, by the P99
# says: you went by the P99, which sees no dropped image
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "A"

# %% wrong: a number for the robot
# says: better: a string is asked, you have 1.
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = 1

# %% wrong: both
# says: better: 'A AND B' is not right.
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = "A and B"

# %% wrong: no robot
# says: better: there is no answer yet. Replace the dots.
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.percentile(r["end_s"] - r["start_s"], 99) for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [1150 - np.sum(r["end_s"] - r["image_s"] <= 0.1) for r in (A, B)]
better = ...

# %% right: with the library and masks
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * am.latency(r["end_s"] - r["start_s"]).p99 for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = np.array([1150 - (r["end_s"] - r["image_s"] < 0.1).sum() for r in (A, B)])
better = "b"

# %% right: rounded P99, tuples
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = (38.7, 79.7)
dropped = (94, 0)
late = (102, 54)

# %% right: whole milliseconds
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = (39, 80)
dropped = [1150 - len(A), 1150 - len(B)]
late = [102.0, 54.0]

# %% right: an order statistic
warm = log[log["image_s"] >= 5]
A, B = warm[warm["robot"] == 0], warm[warm["robot"] == 1]
p99 = [1000 * np.sort(r["end_s"] - r["start_s"])[int(np.ceil(0.99 * len(r))) - 1] for r in (A, B)]
dropped = [1150 - len(A), 1150 - len(B)]
late = [(1150 - len(r)) + np.sum(r["end_s"] - r["image_s"] >= 0.1) for r in (A, B)]

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

# %% right: pandas-free loop
rows = {0: [], 1: []}
for x in log:
    if x["image_s"] >= 5 - 1e-6: rows[int(x["robot"])].append(x)
p99 = np.array([1000 * np.percentile([x["end_s"] - x["start_s"] for x in rows[k]], 99) for k in (0, 1)])
late = [1150 - sum(x["end_s"] - x["image_s"] <= 0.1 + 1e-9 for x in rows[k]) for k in (0, 1)]
dropped = tuple(1150.0 - len(rows[k]) for k in (0, 1))
better = "b"
