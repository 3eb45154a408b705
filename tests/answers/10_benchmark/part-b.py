# %% right: three lines
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% right: both squares multiplied out
lines_split = ["Sum(Sum(y[i,j]**2 - 2*t*y[i,j] + t**2, j), i)", "Sum(Sum(y[i,j]**2, j) - 2*t*R*m(i) + R*t**2, i)", "Sum(Sum(y[i,j]**2, j) - R*m(i)**2 + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% right: with the cross term shown, as a text
lines_split = """
= Sum(Sum((y[i,j]-m(i) + m(i)-t)**2, j), i)  # insert
= Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)   # multiply
= Sum(Sum((y[i,j]-m(i))**2, j) + 2*(m(i)-t)*(Sum(y[i,j], j) - R*m(i)) + R*(m(i)-t)**2, i)  # over r
= Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)  # the bracket is 0
= Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)
"""
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% right: pairs of line and reason; another form of the square
lines_split = [("Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "square"), ("Sum(Sum((y[i,j]-m(i))**2, j), i) + Sum(R*(m(i)-t)**2, i)", "the cross term is 0"), ("Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)", "R in front")]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + sigma_S**2*T*R + sigma_R**2*C/R", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2 + (sigma_S*R*sqrt(T) - sigma_R*sqrt(C))**2/R", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% right: formulas as SymPy objects
S, R, C, T, sigma_S, sigma_R = sp.symbols("S R C T sigma_S sigma_R", positive=True)
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = (S*(R-1)*sigma_R**2 + (S-1)*(R*sigma_S**2 + sigma_R**2))/(S*R-1)
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = sp.sqrt(sigma_R**2*C/(sigma_S**2*T))

# %% right: the sum over the seeds outside
lines_split = ["Sum(Sum((y[i,j]-m(i))**2, j) + Sum(2*(y[i,j]-m(i))*(m(i)-t), j) + Sum((m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + 2*(m(i)-t)*(R*m(i) - R*m(i)) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: the goal at once
# says: lines_split: every line follows, but you leap: 1 of at least 3 lines bring something new.
lines_split = ["Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: only the mean inserted
# says: lines_split: every line follows, but you leap: 1 of at least 3 lines bring something new.
lines_split = ["Sum(Sum((y[i,j]-m(i) + m(i)-t)**2, j), i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: padding
# says: lines_split: every line follows, but you leap: 1 of at least 3 lines bring something new.
lines_split = ["Sum(Sum((t - y[i,j])**2, j), i)", "Sum(Sum((y[i,j] - t)**2*2/2, j), i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: multiplied out, then the goal
# says: lines_split: every line follows, but the sums over j of terms with t go at the very end: s
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t), j), i) + Sum(Sum((m(i)-t)**2, j), i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: the cross term left out too early
# says: lines_split: every line follows, but none shows the square multiplied out, still under bot
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: the factor R is lost
# says: lines_split: line 2: wrong
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + (m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: stops before the end
# says: lines_split: the goal is not reached: the last line agrees with it, but does not have its
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: a name that is not declared
# says: lines_split: line 1: unreadable: dbar is not declared. This part knows the names S, R, y,
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-dbar) + (m(i)-dbar)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: never multiplied out
# says: lines_split: every line follows, but none shows the square multiplied out, still under bot
lines_split = ["Sum(Sum((y[i,j]-m(i) + m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + 2*(m(i)-t)*Sum(y[i,j]-m(i), j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: as if all were independent
# says: this is the variance of one difference, for which all have to be independent
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_S**2 + sigma_R**2"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: divided by S*R
# says: you divided by S*R
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "(S*(R-1)*sigma_R**2 + (S-1)*(R*sigma_S**2+sigma_R**2))/(S*R)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: the factor R forgotten
# says: the second sum lacks its factor R
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "(S*(R-1)*sigma_R**2 + (S-1)*(sigma_S**2+sigma_R**2/R))/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: within alone
# says: this is the variance within scenarios
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: not divided
# says: the two sums are not divided
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "S*(R-1)*sigma_R**2 + (S-1)*(R*sigma_S**2+sigma_R**2)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: the variance of the mean
# says: this is the true variance of the mean
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_S**2/S + sigma_R**2/(S*R)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: an equation
# says: naive: enter the right side alone, without an equals sign and a left side.
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "v = sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: sigma_R not squared
# says: naive: sigma_R + sigma_S*R*(S-1)/(S*R-1) is not right
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R + sigma_S*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: multiplied out, then the end
# says: lines_cost: every line follows, but none has a completed square, of a difference that vani
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + sigma_S**2*T*R + sigma_R**2*C/R", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: the end at once
# says: lines_cost: every line follows, but you leap: 1 of at least 2 lines bring something new. M
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = [">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: equality claimed
# says: lines_cost: line 2: wrong
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", "= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: a square with a plus
# says: lines_cost: every line follows, but none has a completed square, of a difference that vani
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) + sigma_R*sqrt(C/R))**2 - 2*sigma_S*sigma_R*sqrt(C*T)", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: the sign turned
# says: lines_cost: line 2: wrong
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2 + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2", "<= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: the mixed term without 2
# says: lines_cost: line 1: wrong
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + sigma_S*sigma_R*sqrt(C*T)", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: another square that does not vanish there
# says: lines_cost: every line follows, but none has a completed square, of a difference that vani
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R))**2 + (sigma_R*sqrt(C/R))**2", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: best: upside down
# says: this is its inverse
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_S/sigma_R*sqrt(T/C)"

# %% wrong: best: without the root
# says: the root is missing
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R**2*C/(sigma_S**2*T)"

# %% wrong: best: costs swapped
# says: C and T are swapped
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R/sigma_S*sqrt(T/C)"

# %% wrong: best: spreads swapped
# says: sigma_S and sigma_R are swapped
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_S/sigma_R*sqrt(C/T)"

# %% wrong: best: costs left out
# says: the costs are left out
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R/sigma_S"

# %% wrong: best: with S
# says: best is unreadable: S is not declared. This part knows the names sigma_R, sigma_S, C, T on
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R/sigma_S*sqrt(C/T)/S"
