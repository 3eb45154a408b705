# %% wrong: takes the shortcut for the RPE
# says: you subtracted steps in world axes
rpe = (3, 18**0.5)

# %% wrong: averages the RMSEs
# says: you averaged the RMSEs
pooled = "(r + q)/2"

# %% wrong: averages the RMSEs with weights
# says: RMSEs are averaged, if with weights
pooled = "(n*r + m*q)/(n + m)"

# %% wrong: pools as if the runs had one length
# says: both runs weigh the same
pooled = "sqrt((r**2 + q**2)/2)"

# %% wrong: adds the squares
# says: the squares are added, not averaged
pooled = "sqrt(r**2 + q**2)"

# %% wrong: weights exchanged
# says: the weights are exchanged
pooled = "sqrt((m*r**2 + n*q**2)/(n + m))"

# %% wrong: the mean square
# says: the root is missing
pooled = "(n*r**2 + m*q**2)/(n + m)"

# %% wrong: the sum under the root
# says: you did not divide by the number of samples
pooled = "sqrt(n*r**2 + m*q**2)"

# %% wrong: divides outside of the root
# says: the root is taken of the sum alone
pooled = "sqrt(n*r**2 + m*q**2)/(n + m)"

# %% wrong: a sum that nobody has carried out
# says: Sum still stands in your formula
pooled = "sqrt((Sum(r**2, (k, 1, n)) + Sum(q**2, (k, 1, m)))/(n + m))"

# %% wrong: an unknown letter
# says: This part knows the names n, m, r, q only
pooled = "sqrt((n*r**2 + m*p**2)/(n + m))"

# %% wrong: divides by N - 1
# says: you divided by N - 1
ate = (3, 18**0.5 / 2, 0)

# %% wrong: divides the squares by N - 1
# says: the RMSE is divided by N - 1
ate = (3, 2**0.5, 0)

# %% wrong: forgets the root
# says: you forgot the root
ate = (6, 2**0.5, 0)

# %% wrong: aligns first
# says: you aligned first
X = np.array([[0, 0], [3, 0], [6, 0]])
a = am.ate(X, np.array([[0, 0], [3, 0], [3, 3]]))
ate = (a.rmse, a.mean, a.median)

# %% wrong: mean and median exchanged
# says: mean and median are exchanged
ate = (6**0.5, 0, 2**0.5)

# %% wrong: takes the mean of those that err
# says: ate: (2.44949, 1.41421, 1.41421) is not right
ate = (6**0.5, 2**0.5, 2**0.5)

# %% wrong: adds x and y
# says: not put at right angles
ate = (12**0.5, 2, 0)

# %% wrong: rounded more than is asked
# says: you rounded to one decimal
ate = (2.4, 1.4, 0)

# %% wrong: the largest error for the RMSE
# says: the root of the sum, without N
ate = (4.24, 1.41, 0)

# %% wrong: divides the RPE by the number of samples
# says: you divided by all three samples
rpe = (0, 6**0.5)

# %% wrong: mean squares of the RPE
# says: you forgot the root
rpe = (0, 18)

# %% wrong: looks from the end of the step
# says: not as the robot saw them when they began
rpe = (np.sqrt(((3 - 0) ** 2 + 3**2) / 2), np.hypot(6 - 3, 3))

# %% wrong: rounded to whole meters
# says: you rounded to whole meters
rpe = (0, 4)

# %% wrong: forgets the formula
# says: there is no answer yet
pooled = ...

# %% right: by NumPy
ate_series = np.array([0, 0, 18**0.5])
ate = (np.sqrt(np.mean(ate_series**2)), ate_series.mean(), np.median(ate_series))
rpe = tuple(np.sqrt([0, 18]))
pooled = "sqrt(n/(n+m)*r**2 + m/(n+m)*q**2)"

# %% right: lists, rounded, the formula in another order
ate = [2.45, 1.41, 0.0]
rpe = [0.0, 4.24]
pooled = "((m*q*q + n*r*r)/(m + n))**(1/2)"

# %% right: SymPy's numbers and formula
import sympy as sp
n, m, r, q = sp.symbols("n m r q", positive=True)
ate = sp.Matrix([sp.sqrt(6), sp.sqrt(2), 0])
rpe = (sp.Integer(0), 3 * sp.sqrt(2))
pooled = sp.sqrt((n * r**2 + m * q**2) / (n + m))

# %% right: by the library
X = am.planar_poses([[0, 0], [3, 0], [6, 0]], [0, 0, 0])
Y = am.planar_poses([[0, 0], [3, 0], [3, 3]], np.radians([0, 90, 90]))
a = am.ate(X, Y, align="none")
ate = np.array([a.rmse, a.mean, a.median])
rpe = np.array([am.rpe(X, Y, d).translation.rmse for d in (1, 2)])
