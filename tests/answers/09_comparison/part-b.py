# %% wrong: pairs: nothing but the goal
lines_pairs = ["(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: pads with 2/2
lines_pairs = ["2*Sum(Sum((d[j] - d[k])**2, j), k)/(4*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: order of the difference, then a leap
lines_pairs = ["Sum(Sum((d[k] - d[j])**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: order, goal in other forms
lines_pairs = ["Sum(Sum((d[k] - d[j])**2, j), k)/(2*N*(N-1))", "Sum(d[k]**2, k)/(N-1) - N*dbar**2/(N-1)", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: multiplied out, then a leap
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: multiplied out, halves, then a leap
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[j]**2/2 - d[j]*d[k] + d[k]**2/2, j), k)/(N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: multiplied out, order, then a leap
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[k]**2 - 2*d[k]*d[j] + d[j]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: goal in three forms
lines_pairs = ["Sum((d[k]-dbar)**2, k)/(N-1)", "Sum(d[k]**2, k)/(N-1) - N*dbar**2/(N-1)", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: a product of means in the goal
lines_pairs = ["Sum((d[k]-dbar)**2, k)/(N-1)", "(Sum(d[k]**2, k) - dbar*Sum(d[k], k))/(N-1)", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: the mixed term is lost
lines_pairs = ["Sum(Sum(d[j]**2 + d[k]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: a sum over j of what has no j, without N
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + d[k]**2, k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: the inner sum is the mean
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "Sum(Sum(d[j]**2, j) - 2*d[k]*dbar + N*d[k]**2, k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: stops before the end
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: divisor N(N-1) without the 2
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: a letter that is not declared
lines_pairs = ["Sum(Sum(d[m]**2 - 2*d[m]*d[k] + d[k]**2, m), k)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: pairs: empty
lines_pairs = ...
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: independent differences
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: the sign of the covariance
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 + rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: half of it
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: the covariance once
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2 - rho*sigma**2"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: covariance rho
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2 - 2*rho"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: zero
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "0"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: s**2 taken for unbiased
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "1 + (N-1)*rho"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: only s**2 changes
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "1/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: the inverse
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 - rho)/(1 + (N-1)*rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: the root
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "sqrt((1 + (N-1)*rho)/(1 - rho))"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: N instead of N - 1
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + N*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: divided by s**2
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(N*(1 - rho))"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: the variance itself
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "sigma**2*(1 + (N-1)*rho)/N"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: each pair once
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho/2)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: the mean of the square, not of half of it
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(2*(1 - rho))"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: for eight runs
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + 7*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: a bracket is missing
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "1 + (N-1)*rho/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: without N
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: best: nothing but the goal
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: substitutes, never by parts
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(w**2*exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(pi/2)/sqrt(K)", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: by parts, then a leap
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: by parts, then the value in forms
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "sqrt(2*pi/K)/2", "sqrt(pi)/sqrt(2*K)", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: the root of K is lost in the substitution
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: K instead of its root
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))/K", "sqrt(pi/2)/K"]
seeds = 9

# %% wrong: best: the whole Gauss integral
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(2*pi)/sqrt(K)", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: by parts without v
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(v*exp(-K*v**2/2), (v, 0, oo))", "1/K", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: best: the sign of by parts
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["-Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(pi/(2*K))"]
seeds = 9

# %% wrong: exponential seeds
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 3

# %% wrong: uniform seeds
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 5

# %% wrong: the root of 3
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 3**0.5

# %% wrong: as a text
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = "9"

# %% wrong: pairs: halves, multiplied out, then a leap
lines_pairs = ["Sum(Sum((d[j]-d[k])**2/2, j), k)/(N*(N-1))","Sum(Sum(d[j]**2/2 - d[j]*d[k] + d[k]**2/2, j), k)/(N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% wrong: best: the derivative is seen, and no more
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Integral(-v*Derivative(exp(-K*v**2/2), v), (v, 0, oo))", "sqrt(pi)/sqrt(2*K)", "sqrt(pi/(2*K))"]
seeds = 9

# %% right: N is canceled at once
lines_pairs = ["Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))", "(Sum(d[k]**2,k) + Sum(d[k]**2,k) - 2*N*dbar**2)/(2*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% right: another index, and the ends of by parts
lines_pairs = ["Sum(Sum(d[i]**2 - 2*d[i]*d[k] + d[k]**2, i), k)/(2*N*(N-1))", "(2*N*Sum(d[k]**2,k) - 2*N*dbar*N*dbar)/(2*N*(N-1))", "(Sum(d[k]**2, k) - N*dbar**2)/(N-1)"]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = ["Limit(-v*exp(-K*v**2/2), v, oo) + Integral(exp(-K*v**2/2), (v, 0, oo))", "Integral(exp(-K*v**2/2), (v, 0, oo))","Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)", "sqrt(pi/(2*K))"]
seeds = 9

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
seeds = 9

# %% right: deviations from the mean
lines_pairs = """
    = Sum(Sum(((d[j] - dbar) - (d[k] - dbar))**2, j), k)/(2*N*(N-1))   # in and out
    = Sum(Sum((d[j] - dbar)**2 - 2*(d[j] - dbar)*(d[k] - dbar) + (d[k] - dbar)**2, j), k)/(2*N*(N-1))
    = (2*N*Sum((d[k] - dbar)**2, k))/(2*N*(N-1))    # deviations add up to 0
    = Sum((d[k] - dbar)**2, k)/(N-1)
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)           # D1 of the lecture
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% right: sums with limits, the inner sum at once
lines_pairs = [
    "Sum((d[j] - d[k])*(d[j] - d[k]), (j, 1, N), (k, 1, N))/(2*N*(N-1))",
    ("Sum(Sum(d[j]**2, (j, 1, N)) - 2*d[k]*Sum(d[j], (j, 1, N)) + N*d[k]**2, (k, 1, N))/(2*N*(N-1))", "over j"),
    ("(N*Sum(d[j]**2, (j, 1, N)) - 2*N*dbar*N*dbar + N*Sum(d[k]**2, (k, 1, N)))/(2*N*(N-1))", "over k"),
    "(Sum(d[k]**2, (k, 1, N)) - N*dbar**2)/(N-1)",
]
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% right: three double sums
lines_pairs = """
    Sum(Sum((d[j] - d[k])**2, j), k)/(2*N*(N-1))
    = (Sum(Sum(d[j]**2, j), k) - 2*Sum(Sum(d[j]*d[k], j), k) + Sum(Sum(d[k]**2, j), k))/(2*N*(N-1))
    = (N*Sum(d[j]**2, j) - 2*Sum(d[j], j)*Sum(d[k], k) + N*Sum(d[k]**2, k))/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*(N*dbar)**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
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
mean_square = "2*sigma**2*(1 - rho)"
factor = "((N-1)*rho + 1)/(1-rho)"
lines_best = """
    = Integral(w**2*exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)
    = sqrt(pi/2)/sqrt(K)
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% right: another scale in the substitution
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = Integral(exp(-K*v**2/2), (v, 0, oo))
    = sqrt(2/K)*Integral(exp(-x**2), (x, 0, oo))
    = sqrt(2/K)*sqrt(pi)/2
    = sqrt(pi/(2*K))
"""
seeds = 9

# %% right: by a gamma function
lines_pairs = """
    = Sum(Sum(d[j]**2 - 2*d[j]*d[k] + d[k]**2, j), k)/(2*N*(N-1))
    = Sum(Sum(d[j]**2, j) - 2*d[k]*N*dbar + N*d[k]**2, k)/(2*N*(N-1))
    = (2*N*Sum(d[k]**2, k) - 2*N**2*dbar**2)/(2*N*(N-1))
    = (Sum(d[k]**2, k) - N*dbar**2)/(N-1)
"""
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = """
    = sqrt(2/K)*Integral(sqrt(w)*exp(-w), (w, 0, oo))
    = sqrt(2/K)*gamma(3/2)
    = sqrt(2/K)*sqrt(pi)/2
    = sqrt(pi/(2*K))
"""
seeds = 9

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
mean_square = "2*sigma**2*(1 - rho)"
factor = "(1 + (N-1)*rho)/(1 - rho)"
lines_best = [
    "Integral(exp(-K*v**2/2), (v, 0, oo))",
    "Integral(exp(-w**2/2), (w, 0, oo))/sqrt(K)",
    "Integral(exp(-w**2/2), (w, -oo, oo))/(2*sqrt(K))",
    "sqrt(2*pi)/(2*sqrt(K))",
    "sqrt(pi/(2*K))",
]
seeds = 9
