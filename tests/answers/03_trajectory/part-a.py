# %% wrong: takes the shortcut for the RPE
ate = (6**0.5, 2**0.5, 0)
rpe = (3, 18**0.5)
pooled = "sqrt((n*r**2 + m*q**2)/(n + m))"
# %% wrong: averages the RMSEs
ate = (6**0.5, 2**0.5, 0)
rpe = (0, 18**0.5)
pooled = "(r + q)/2"
# %% wrong: averages the RMSEs with weights
ate = (6**0.5, 2**0.5, 0)
rpe = (0, 18**0.5)
pooled = "(n*r + m*q)/(n + m)"
# %% wrong: pools as if the runs had one length
ate = (6**0.5, 2**0.5, 0)
rpe = (0, 18**0.5)
pooled = "sqrt((r**2 + q**2)/2)"
# %% wrong: divides by N - 1
ate = (3, 18**0.5 / 2, 0)
rpe = (0, 18**0.5)
pooled = "sqrt((n*r**2 + m*q**2)/(n + m))"
# %% wrong: forgets the root
ate = (6, 2**0.5, 0)
rpe = (0, 18**0.5)
pooled = "sqrt((n*r**2 + m*q**2)/(n + m))"
# %% wrong: takes the middle sample for the median
ate = (6**0.5, 2**0.5, 2**0.5)
rpe = (0, 18**0.5)
pooled = "sqrt((n*r**2 + m*q**2)/(n + m))"
# %% wrong: divides the RPE by the number of samples
ate = (6**0.5, 2**0.5, 0)
rpe = (0, 6**0.5)
pooled = "sqrt((n*r**2 + m*q**2)/(n + m))"
# %% wrong: forgets the formula
ate = (6**0.5, 2**0.5, 0)
rpe = (0, 18**0.5)
pooled = ...
# %% right: by NumPy
ate_series = np.array([0, 0, 18**0.5])
ate = (np.sqrt(np.mean(ate_series**2)), ate_series.mean(), np.median(ate_series))
rpe = tuple(np.sqrt([0, 18]))
pooled = "sqrt(n/(n+m)*r**2 + m/(n+m)*q**2)"
# %% right: lists, rounded, the formula in another order
ate = [2.45, 1.414, 0.0]
rpe = [0.0, 4.243]
pooled = "((m*q*q + n*r*r)/(m + n))**(1/2)"
