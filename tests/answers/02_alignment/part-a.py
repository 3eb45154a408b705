# %% wrong: turns the truth onto the estimate
theta_deg = -126.87
t_star = (4, -3)
J_min = 2

# %% wrong: atan instead of atan2
theta_deg = np.degrees(np.arctan(24 / -18))
t_star = (0, -5)
J_min = 2

# %% wrong: the arguments of atan2 are swapped
theta_deg = np.degrees(np.arctan2(-18, 24))
t_star = (0, -5)
J_min = 2

# %% wrong: the means are not subtracted
theta_deg = np.degrees(np.arctan2(21, 3))
t_star = (0, -5)
J_min = 2

# %% wrong: radians
theta_deg = 2.2143
t_star = (0, -5)
J_min = 2

# %% wrong: t is the difference of the means
theta_deg = 126.87
t_star = (0, -1)
J_min = 2

# %% wrong: t with the transposed rotation
theta_deg = 126.87
t_star = (3.2, -3.4)
J_min = 2

# %% wrong: t with three numbers
theta_deg = 126.87
t_star = (0, -5, 126.87)
J_min = 2

# %% wrong: A is subtracted once
theta_deg = 126.87
t_star = (0, -5)
J_min = 32

# %% wrong: the mean of the squares instead of their sum
theta_deg = 126.87
t_star = (0, -5)
J_min = 2 / 3

# %% wrong: another turn of a wrong angle
theta_deg = 360 - 126.87
t_star = (0, -5)
J_min = 2

# %% wrong: the root mean square instead of the sum
theta_deg = 126.87
t_star = (0, -5)
J_min = (2 / 3) ** 0.5

# %% wrong: one answer is missing
theta_deg = 126.87
t_star = (0, -5)
J_min = ...

# %% wrong: constants
theta_deg = t_star = J_min = 0

# %% wrong: a string
theta_deg = "atan2(24, -18)"
t_star = "(0, -5)"
J_min = "2"

# %% wrong: an array where one number is asked
theta_deg = [126.87, -53.13]
t_star = (0, -5)
J_min = 2

# %% wrong: nan
theta_deg = float("nan")
t_star = (0, -5)
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
t_star = (0, -5)
J_min = 2
