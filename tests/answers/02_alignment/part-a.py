# %% wrong: turns the truth onto the estimate
# says: you turned the truth onto the estimate
theta_deg = -126.87
t_star = (4, -3)
J_min = 2

# %% wrong: atan instead of atan2
# says: atan, which covers half a turn only, misled you
theta_deg = np.degrees(np.arctan(24 / -18))
J_min = 2

# %% wrong: the arguments of atan2 are swapped
# says: the two arguments of atan2 are swapped
theta_deg = np.degrees(np.arctan2(-18, 24))
J_min = 2

# %% wrong: the means are not subtracted
# says: the means are still in your products
theta_deg = np.degrees(np.arctan2(21, 3))
J_min = 2

# %% wrong: radians
# says: this is in radians
theta_deg = 2.2143
J_min = 2

# %% wrong: t is the difference of the means
# says: you did not rotate the mean of the estimate
t_star = (0, -1)
J_min = 2

# %% wrong: t with the transposed rotation
# says: you rotated the wrong way
t_star = (3.2, -3.4)
J_min = 2

# %% wrong: t with three numbers
# says: t_star: a tuple of 2 results is asked, you have (0, -5, 126.87).
t_star = (0, -5, 126.87)
J_min = 2

# %% wrong: A is subtracted once
# says: the mixed term lost its factor 2
J_min = 32

# %% wrong: the mean of the squares instead of their sum
# says: you divided by N
J_min = 2 / 3

# %% wrong: another turn of a wrong angle
# says: you turned the truth onto the estimate
theta_deg = 360 - 126.87
J_min = 2

# %% wrong: the root mean square instead of the sum
# says: this is the root mean square
J_min = (2 / 3) ** 0.5

# %% wrong: one answer is missing
# says: J_min: there is no answer yet. Replace the dots.
J_min = ...

# %% wrong: constants
# says: theta_deg: 0 is not right.
theta_deg = t_star = J_min = 0

# %% wrong: a string
# says: theta_deg: numbers are asked, you have 'atan2(24, -18)'.
theta_deg = "atan2(24, -18)"
t_star = "(0, -5)"
J_min = "2"

# %% wrong: an array where one number is asked
# says: theta_deg: one number is asked, you have [126.87, -53.13].
theta_deg = [126.87, -53.13]
J_min = 2

# %% wrong: nan
# says: theta_deg: a finite number is asked.
theta_deg = float("nan")
J_min = 2

# %% right: computed, with arrays
theta_deg = np.rad2deg(np.arctan2(24, -18))
rotation = np.array([[-0.6, -0.8], [0.8, -0.6]])
t_star = p.mean(axis=0) - rotation @ p_hat.mean(axis=0)
J_min = np.sum((p - p_hat @ rotation.T - t_star) ** 2)

# %% right: rounded by hand, lists
theta_deg = 126.9
t_star = [0.0, -5.0]
J_min = 2.0

# %% right: a full turn less
theta_deg = 126.87 - 360
J_min = 2

# %% wrong: the angle at which J is largest
# says: atan, which covers half a turn only, misled you
theta_deg = -53.13

# %% wrong: rounded to whole degrees
# says: theta_deg: you rounded too far.
theta_deg = 127

# %% wrong: C counts as positive
# says: a sign is lost: C counts as positive
theta_deg = 53.13

# %% wrong: half of it
# says: you halved the angle
theta_deg = 63.435

# %% wrong: the sign of t
# says: the sign of t is turned
t_star = (0, 5)

# %% wrong: sums for means
# says: you took sums for means
t_star = (0, -15)

# %% wrong: the mixed term is added
# says: the mixed term is added
J_min = 24 + 38 + 2 * 30

# %% wrong: the mixed term is forgotten
# says: the mixed term is forgotten
J_min = 62

# %% wrong: nothing is aligned
# says: nothing is aligned
J_min = np.sum((p - p_hat) ** 2)

# %% wrong: the mean over N - 1
# says: you divided by N - 1
J_min = 1

# %% wrong: t as one number
# says: t_star: a tuple of 2 results is asked, you have -5.
t_star = -5

# %% right: radians turned into degrees, a column
import math

theta_deg = math.degrees(math.atan2(24, -18))
t_star = np.array([[0.0], [-5.0]])
J_min = [2]

# %% right: the means subtracted in place, names used up
centered = p - p.mean(axis=0), p_hat - p_hat.mean(axis=0)
e = R = C = S = sum = 0
theta_deg = 126.8699
p = p - p.mean(axis=0)
p_hat = None

# %% right: the library
best = am.align(p, p_hat)
theta_deg, t_star, J_min = np.degrees(best.angle), best.translation, best.residual

# %% right: a full turn more, t nearly
theta_deg, t_star, J_min = 486.9, (0.001, -5), 2.004
