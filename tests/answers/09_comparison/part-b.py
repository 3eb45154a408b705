# %% wrong: pairs: nothing but the goal
# says: lines_pairs: every line follows, but you leap: 1 of at least 3 lines bring something new.
lines_pairs = ["(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: pads with 2/2
# says: lines_pairs: every line follows, but you leap: 1 of at least 3 lines bring something new.
lines_pairs = ["2*Sum(Sum((d[j] - d[k])**2, j), k)/(4*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: order of the difference, then a leap
# says: lines_pairs: every line follows, but you leap: 1 of at least 3 lines bring something new.
lines_pairs = ["Sum(Sum((d[k] - d[j])**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: order, goal in other forms
# says: lines_pairs: every line follows, but you leap: 2 of at least 3 lines bring something new.
lines_pairs = ["Sum(Sum((d[k] - d[j])**2, j), k)/(2*N*(N-1))", "Sum(d[k]**2, k)/(N-1) - N*dbar**2/(N-1)", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: multiplied out, then a leap
# says: lines_pairs: every line follows, but you leap: 2 of at least 3 lines bring something new.
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: multiplied out, halves, then a leap
# says: lines_pairs: every line follows, but the double sum goes and the end is there: show what i
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[j]**2/2 - d[j]*d[k] + d[k]**2/2, j), k)/(N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: multiplied out, order, then a leap
# says: lines_pairs: line 2: This line is the same as the line before: the step changes nothing
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[k]**2 - 2*d[k]*d[j] + d[j]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: goal in three forms
# says: lines_pairs: every line follows, but none shows the square multiplied out, still under bot
lines_pairs = ["Sum((d[k]-dbar)**2, k)/(N-1)", "Sum(d[k]**2, k)/(N-1) - N*dbar**2/(N-1)", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: a product of means in the goal
# says: lines_pairs: every line follows, but none shows the square multiplied out, still under bot
lines_pairs = ["Sum((d[k]-dbar)**2, k)/(N-1)", "(Sum(d[k]**2, k) - dbar*Sum(d[k], k))/(N-1)", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: the mixed term is lost
# says: lines_pairs: line 1: wrong
lines_pairs = ["Sum(Sum(d[j]**2 + d[k]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: a sum over j of what has no j, without N
# says: lines_pairs: line 2: wrong
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + d[k]**2, k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: the inner sum is the mean
# says: lines_pairs: line 2: wrong
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[j]**2, j) - 2*d[k]*dbar + N*d[k]**2, k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: stops before the end
# says: lines_pairs: the goal is not reached: the last line agrees with it, but does not have its
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: divisor N(N-1) without the 2
# says: lines_pairs: line 2: wrong
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: a letter that is not declared
# says: lines_pairs: line 1: unreadable: m has no range: declare it as in d sequence m = 1..N, or
lines_pairs = ["Sum(Sum(d[m]**2 - 2*d[m]*d[k] + d[k]**2, m), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: pairs: empty
# says: lines_pairs: the derivation: there is no answer yet. Replace the dots.
lines_pairs = ...
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: independent differences
# says: you left out the covariance
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: the sign of the covariance
# says: the sign of the covariance is turned
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 + rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: half of it
# says: this is half of it: the mean of s**2
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "sigma**2*(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: the covariance once
# says: the covariance counts once, not twice
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2 - rho*sigma**2"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: covariance rho
# says: the covariance is rho, without a variance
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2 - 2*rho"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: zero
# says: j and k are taken for the same run
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "0"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: s**2 taken for unbiased
# says: you took sigma**2 for the mean of s**2
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "1 + (N-1)*rho"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: only s**2 changes
# says: you took sigma**2/N for the variance of the mean
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "1/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: the inverse
# says: this is its inverse
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 - rho)/(1 + (N-1)*rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: the root
# says: this is its root
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "sqrt((1 + (N-1)*rho)/(1 - rho))"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: N instead of N - 1
# says: each of the N runs is paired with itself, too
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 + N*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: divided by s**2
# says: you divided by the mean of s**2, not of s**2/N
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 + (N-1)*rho)/(N*(1 - rho))"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: the variance itself
# says: this is the variance of the mean
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "sigma**2*(1 + (N-1)*rho)/N"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: each pair once
# says: each pair is counted once
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 + (N-1)*rho/2)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: the mean of the square, not of half of it
# says: you took 2*sigma**2*(1-rho) for the mean of s**2
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 + (N-1)*rho)/(2*(1 - rho))"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: for eight runs
# says: the factor is that of eight runs
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 + 7*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: a bracket is missing
# says: a bracket is missing
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "1 + (N-1)*rho/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: without N
# says: the factor is that of two runs
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "(1 + rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: best: nothing but the goal
# says: lines_best: every line follows, but you leap: 1 of at least 3 lines bring something new. M
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["sqrt(pi/(2*K))"]

# %% wrong: best: substitutes, never by parts
# says: lines_best: every line follows, but nothing was integrated by parts: no line has an integr
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(w**2*exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(pi/2)/sqrt(K)", "sqrt(pi/(2*K))"]

# %% wrong: best: by parts, then a leap
# says: lines_best: every line follows, but you leap: 2 of at least 3 lines bring something new. M
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "sqrt(pi/(2*K))"]

# %% wrong: best: by parts, then the value in forms
# says: lines_best: every line follows, but none has an integral without K: substitute.
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "sqrt(2*pi/K)/2", "sqrt(pi)/sqrt(2*K)", "sqrt(pi/(2*K))"]

# %% wrong: best: the root of K is lost in the substitution
# says: lines_best: line 2:
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))", "sqrt(pi/(2*K))"]

# %% wrong: best: K instead of its root
# says: lines_best: line 2:
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))/K", "sqrt(pi/2)/K"]

# %% wrong: best: the whole Gauss integral
# says: lines_best: line 3:
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(2*pi)/sqrt(K)", "sqrt(pi/(2*K))"]

# %% wrong: best: by parts without v
# says: lines_best: line 1:
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(v*exp(-K*v**2/2), (v, 0, oo))", "1/K", "sqrt(pi/(2*K))"]

# %% wrong: best: the sign of by parts
# says: lines_best: line 1:
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["-Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(pi/(2*K))"]

# %% wrong: exponential seeds
# says: you took the errors for exponential
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 3

# %% wrong: uniform seeds
# says: you took the errors for uniform
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 5

# %% wrong: the root of 3
# says: you took the root the other way round
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 3**0.5

# %% wrong: as a text
# says: seeds: numbers are asked, you have '9'.
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = "9"

# %% wrong: pairs: halves, multiplied out, then a leap
# says: lines_pairs: every line follows, but the double sum goes and the end is there: show what i
lines_pairs = ["Sum(Sum((d[j]-d[k])**2/2, j), k)/(N*(N-1))","Sum(Sum(d[j]**2/2 - d[j]*d[k] + d[k]**2/2, j), k)/(N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% wrong: best: the derivative is seen, and no more
# says: lines_best: every line follows, but nothing was integrated by parts: no line has an integr
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = ["Integral(-v*Derivative(exp(-K*v**2/2), v), (v, 0, oo))", "sqrt(pi)/sqrt(2*K)", "sqrt(pi/(2*K))"]

# %% right: N is canceled at once
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2,k) + Sum(d[k]**2,k) - 2*N*dbar**2)/(2*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% right: another index, and the ends of by parts
lines_pairs = ["Sum(Sum(d[i]**2 - 2*d[i]*d[k] + d[k]**2, i), k)/(2*N*(N-1))", "(2*N*Sum(d[k]**2,k) - 2*N*dbar*N*dbar)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
lines_best = ["Limit(-v*exp(-K*v**2/2), v, oo) + Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-K*v**2/2), (v, 0, oo))","Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(pi/(2*K))"]

# %% right: lines as a list, terse
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(N*Sum(d[k]**2, k) - 2*Sum(d[j], j)*Sum(d[k], k) + N*Sum(d[k]**2, k))/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2 - 2*rho*sigma**2"
factor = "1 + N*rho/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% right: deviations from the mean
lines_pairs = """
    = Sum(Sum(((d[j] - dbar) - (d[k] - dbar))**2, j), k)/(2*N*(N-1))   # in and out
    = Sum(Sum((d[j] - dbar)**2 - 2*(d[j] - dbar)*(d[k] - dbar) + (d[k] - dbar)**2, j), k)/(2*N*(N-1))
    = (2*N*Sum((d[k] - dbar)**2, k))/(2*N*(N-1))    # deviations add up to 0
    = Sum((d[k] - dbar)**2, k)/(N-1)
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)           # D1 of the lecture
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% right: sums with limits, the inner sum at once
lines_pairs = [
    "Sum((d[j] - d[k])*(d[j] - d[k]), (j, 1, N), (k, 1, N))/(2*N*(N-1))",
    ("Sum(Sum(d[j]**2, (j, 1, N)) - 2*d[k]*Sum(d[j], (j, 1, N)) + N*d[k]**2, (k, 1, N))/(2*N*(N-1))", "over j"),
    ("(N*Sum(d[j]**2, (j, 1, N)) - 2*N*dbar*N*dbar + N*Sum(d[k]**2, (k, 1, N)))/(2*N*(N-1))", "over k"),
    "(Sum(d[k]**2, (k, 1, N)) - N*dbar**2)/(N-1)",
]
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% right: three double sums
lines_pairs = """
    Sum(Sum((d[j] - d[k])**2, j), k)/(2*N*(N-1))
    = (Sum(Sum(d[j]**2, j), k) - 2*Sum(Sum(d[j]*d[k], j), k) + Sum(Sum(d[k]**2, j), k))/(2*N*(N-1))
    = (N*Sum(d[j]**2, j) - 2*Sum(d[j], j)*Sum(d[k], k) + N*Sum(d[k]**2, k))/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*(N*dbar)**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9.0

# %% right: substitution first
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
factor = "((N-1)*rho + 1)/(1-rho)"
lines_best = """
    = Integral(w**2*exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""

# %% right: another scale in the substitution
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = sqrt(2/K)*Integral(exp(-x**2), (x, 0, oo))
    = sqrt(2/K)*sqrt(pi)/2
    = sqrt(pi/(2*K))
"""

# %% right: by a gamma function
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = """
    = sqrt(2/K)*Integral(sqrt(w)*exp(-w), (w, 0, oo))
    = sqrt(2/K)*gamma(3/2)
    = sqrt(2/K)*sqrt(pi)/2
    = sqrt(pi/(2*K))
"""

# %% right: SymPy objects
_s, _r, _N = sp.symbols("sigma rho N")
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = 2 * _s**2 * (1 - _r)
factor = (1 + (_N - 1) * _r) / (1 - _r)
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = np.int64(9)

# %% right: an integral over all numbers
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
lines_best = [
    "Integral(exp(-K*v**2/2), (v, 0, oo))",
    "Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)",
    "Integral(exp(-w**2/2), (w, -oo, oo))/(2*sqrt(K))",
    "sqrt(2*pi)/(2*sqrt(K))",
    "sqrt(pi/(2*K))",
]

# %% right: pairs with reasons, list
lines_pairs = [("(Sum(Sum(d[j]**2, j), k) - 2*Sum(Sum(d[j]*d[k], j), k) + Sum(Sum(d[k]**2, j), k))/(2*N*(N-1))", "multiply"),
  ("(N*Sum(d[j]**2, j) - 2*Sum(d[k], k)*Sum(d[j], j) + N*Sum(d[k]**2, k))/(2*N*(N-1))", "carry out"),
  ("(2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))", "the mean"),
  ("(Sum(d[k]**2, k) - N*dbar**2)/(N-1)", "cancel")]

# %% right: two sums first, halves
lines_pairs = """
= Sum(Sum(d[j]**2 + d[k]**2 - 2*d[j]*d[k], j), k)/(2*N*(N-1))
= (2*N*Sum(d[k]**2, k) - 2*Sum(Sum(d[j]*d[k], j), k))/(2*N*(N-1))
= (N*Sum(d[k]**2, k) - (N*dbar)**2)/(N*(N-1))
= (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
