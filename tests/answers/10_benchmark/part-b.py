# %% right: three lines
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% right: both squares multiplied out
lines_split = ["Sum(Sum(y[i,j]**2 - 2*t*y[i,j] + t**2, j), i)", "Sum(Sum(y[i,j]**2, j) - 2*t*R*m(i) + R*t**2, i)", "Sum(Sum(y[i,j]**2, j) - R*m(i)**2 + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
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
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% right: pairs of line and reason; another form of the square
lines_split = [("Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "square"), ("Sum(Sum((y[i,j]-m(i))**2, j), i) + Sum(R*(m(i)-t)**2, i)", "the cross term is 0"), ("Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)", "R in front")]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
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
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: the goal at once
lines_split = ["Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: only the mean inserted
lines_split = ["Sum(Sum((y[i,j]-m(i) + m(i)-t)**2, j), i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: padding
lines_split = ["Sum(Sum((t - y[i,j])**2, j), i)", "Sum(Sum((y[i,j] - t)**2*2/2, j), i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: multiplied out, then the goal
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t), j), i) + Sum(Sum((m(i)-t)**2, j), i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: the cross term left out too early
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: the factor R is lost
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + (m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: stops before the end
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: a name that is not declared
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-dbar) + (m(i)-dbar)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: split: never multiplied out
lines_split = ["Sum(Sum((y[i,j]-m(i) + m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + 2*(m(i)-t)*Sum(y[i,j]-m(i), j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: as if all were independent
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_S**2 + sigma_R**2"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: divided by S*R
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "(S*(R-1)*sigma_R**2 + (S-1)*(R*sigma_S**2+sigma_R**2))/(S*R)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: the factor R forgotten
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "(S*(R-1)*sigma_R**2 + (S-1)*(sigma_S**2+sigma_R**2/R))/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: within alone
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: not divided
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "S*(R-1)*sigma_R**2 + (S-1)*(R*sigma_S**2+sigma_R**2)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: the variance of the mean
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_S**2/S + sigma_R**2/(S*R)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: an equation
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "v = sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: naive: sigma_R not squared
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R + sigma_S*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: multiplied out, then the end
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + sigma_S**2*T*R + sigma_R**2*C/R", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: the end at once
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = [">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: equality claimed
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", "= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: a square with a plus
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) + sigma_R*sqrt(C/R))**2 - 2*sigma_S*sigma_R*sqrt(C*T)", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: the sign turned
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2 + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2", "<= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: the mixed term without 2
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + sigma_S*sigma_R*sqrt(C*T)", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: cost: another square that does not vanish there
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R))**2 + (sigma_R*sqrt(C/R))**2", ">= (sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R*sqrt(C)/(sigma_S*sqrt(T))"

# %% wrong: best: upside down
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_S/sigma_R*sqrt(T/C)"

# %% wrong: best: without the root
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R**2*C/(sigma_S**2*T)"

# %% wrong: best: costs swapped
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R/sigma_S*sqrt(T/C)"

# %% wrong: best: spreads swapped
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_S/sigma_R*sqrt(C/T)"

# %% wrong: best: costs left out
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R/sigma_S"

# %% wrong: best: with S
lines_split = ["Sum(Sum((y[i,j]-m(i))**2 + 2*(y[i,j]-m(i))*(m(i)-t) + (m(i)-t)**2, j), i)", "Sum(Sum((y[i,j]-m(i))**2, j) + R*(m(i)-t)**2, i)", "Sum(Sum((y[i,j] - m(i))**2, j), i) + R*Sum((m(i) - t)**2, i)"]
naive = "sigma_R**2 + sigma_S**2*R*(S-1)/(S*R-1)"
lines_cost = ["sigma_S**2*C + sigma_R**2*T + (sigma_S*sqrt(T*R) - sigma_R*sqrt(C/R))**2 + 2*sigma_S*sigma_R*sqrt(C*T)", ">= sigma_S**2*C + sigma_R**2*T + 2*sigma_S*sigma_R*sqrt(C*T)", "(sigma_S*sqrt(C) + sigma_R*sqrt(T))**2"]
best = "sigma_R/sigma_S*sqrt(C/T)/S"
