# %% wrong: nothing but the results
lines_widest = ["1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: a sum without its last term, then a leap
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,1,n)) - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the sum is 1 as it stands
lines_widest = ["1", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: one end only is taken off
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: both ends have the same power
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - 2*q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the ends are added
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) + (1-q)**n + q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the powers of the ends exchanged for binomials
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - n*q**n - n*(1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: padded with 2/2
lines_widest = ["2*Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,1,n-1))/2", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: padded with plus and minus the same
lines_widest = ["1 - q**n - (1-q)**n + q - q", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the order of the ends is turned, no sum
lines_widest = ["1 - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: counts turned around, then a leap
lines_widest = ["Sum(binomial(n,k)*q**(n-k)*(1-q)**k, (k,1,n-1))", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: a power that is no binomial
lines_widest = ["1**n - q**n - (1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: an unknown letter
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-p)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the mean is claimed
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the constant is taken out, then a leap
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["lam*Integral(t*exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the value of the integral from a table
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam - c*exp(-lam*c) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: by parts with the wrong sign
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["c*exp(-lam*c) + Integral(exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: by parts, the minus under the integral
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["-c*exp(-lam*c) - Integral(exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: by parts, lam is lost
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t)/lam, (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: integrated to infinity
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,oo))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: padded with a half
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*lam*exp(-lam*t), (t,0,c))/2 + Integral(t*lam*exp(-lam*t), (t,0,c))/2 + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: the integral split in two, then a leap
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*lam*exp(-lam*t), (t,0,c/2)) + Integral(t*lam*exp(-lam*t), (t,c/2,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: an integral over nothing is added
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam + Integral(exp(-t), (t,0,0))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: another integral and its value are added
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam + Integral(exp(-t), (t,0,1)) - 1 + exp(-1)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: an antiderivative from a table
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(-c-1/lam)*exp(-lam*c) + 1/lam + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: a fraction that is 1, to the power n
lines_widest = ["(q/q)**n - q**n - (1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% wrong: ends before the last line
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "1/lam - exp(-lam*c)/lam"]
missing = "exp(-lam*c)"

# %% wrong: the mean for ever
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "1/lam"]
missing = "exp(-lam*c)"

# %% wrong: what is left, not what is missing
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "1 - exp(-lam*c)"

# %% wrong: in seconds
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)/lam"

# %% wrong: divided by the wrong mean
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)/(1 - exp(-lam*c))"

# %% wrong: the mean itself
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "(1-exp(-lam*c))/lam"

# %% wrong: the sign turned
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "-exp(-lam*c)"

# %% wrong: for dropped runs
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "lam*c*exp(-lam*c)/(1-exp(-lam*c))"

# %% wrong: the ratio of the means
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "1/(1-exp(-lam*c))"

# %% wrong: missing without lam
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-c)"

# %% wrong: an equation
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "missing = exp(-lam*c)"

# %% wrong: lambda by another name
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-r*c)"

# %% wrong: a number
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = 0.22

# %% wrong: the last is missing
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = ...

# %% right: texts with signs and reasons, all the way
lines_widest = """
    = Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,1,n)) - q**n   # add k = n
    = Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n   # add k = 0
    = (q + (1-q))**n - (1-q)**n - q**n   # binomial theorem
    = 1 - q**n - (1-q)**n   # 1 to the n
"""
lines_entered = """
    = -c*exp(-lam*c) + Integral(exp(-lam*t), (t,0,c)) + c*exp(-lam*c)   # by parts
    = Integral(exp(-lam*t), (t,0,c))   # cancel
    = (1-exp(-lam*c))/lam   # integrate
"""
missing = "1 - lam*((1-exp(-lam*c))/lam)"

# %% right: the binomial theorem at once, pairs
lines_widest = [("(q + (1-q))**n - q**n - (1-q)**n", "binomial theorem"), ("1 - q**n - (1-q)**n", "")]
lines_entered = [("Integral(exp(-lam*t), (t,0,c))", "by parts"), ("-exp(-lam*c)/lam + 1/lam", "integrate"), ("(1-exp(-lam*c))/lam", "one fraction")]
missing = "exp(-lam*c)"

# %% right: the given lines first, the sum in front
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,1,n-1))", "-q**n - (1-q)**n + Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n))", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*lam*exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "-c*exp(-lam*c) + 0 + Integral(exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-c*lam)"

# %% right: binomials of the ends written out
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - binomial(n,0)*q**0*(1-q)**n - binomial(n,n)*q**n*(1-q)**0", "1 - (1-q)**n - q**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "1/exp(lam*c)"

# %% right: by parts with a derivative
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = """
    = Integral(t*Derivative(-exp(-lam*t), t), (t,0,c)) + c*exp(-lam*c)
    = -c*exp(-lam*c) - Integral(-exp(-lam*t), (t,0,c)) + c*exp(-lam*c)
    = Integral(exp(-lam*t), (t,0,c))
    = (1-exp(-lam*c))/lam
"""
missing = "e**(-lam*c)".replace("e**", "exp")

# %% right: the failures with density to infinity
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*lam*exp(-lam*t), (t,0,c)) + c*Integral(lam*exp(-lam*t), (t,c,oo))", "Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "(1/lam - (1-exp(-lam*c))/lam)/(1/lam)"

# %% right: t for lam t first, another index
lines_widest = ["Sum(binomial(n,i)*q**i*(1-q)**(n-i), (i,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*exp(-t), (t,0,lam*c))/lam + c*exp(-lam*c)", "(-lam*c*exp(-lam*c) + Integral(exp(-t), (t,0,lam*c)))/lam + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% right: factorials, all for ever minus the rest
lines_widest = ["Sum(factorial(n)/(factorial(k)*factorial(n-k))*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,oo)) - Integral(exp(-lam*t), (t,c,oo))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)"

# %% right: factors counted downward
lines_widest = ["Sum(binomial(n,k)*(1-q)**k*q**(n-k), (k,0,n)) - q**n - (1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = "= Integral(exp(-lam*u), (u,0,c))\n= (1-exp(-lam*c))/lam".replace("u", "t")
missing = "exp(-lam*c)"

# %% right: SymPy objects
lam, c, t, q = sp.symbols("lam c t q", positive=True)
n = sp.Symbol("n", integer=True, positive=True)
k = sp.Symbol("k", integer=True)
whole = sp.Sum(sp.binomial(n, k) * q**k * (1 - q) ** (n - k), (k, 0, n))
lines_widest = [whole - q**n - (1 - q) ** n, 1 - q**n - (1 - q) ** n]
rest = sp.Integral(sp.exp(-lam * t), (t, 0, c))
lines_entered = [rest, (1 - sp.exp(-lam * c)) / lam]
missing = sp.exp(-lam * c)
