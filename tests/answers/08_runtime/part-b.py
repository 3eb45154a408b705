# %% wrong: nothing but the results
# says: lines_widest: every line follows, but you leap: 1 of at least 2 lines bring something new.
lines_widest = ["1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: a sum without its last term, then a leap
# says: lines_widest: every line follows, but none has the sum over all counts from 0 to n, to whi
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,1,n)) - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: the sum is 1 as it stands
# says: lines_widest: line 1: wrong
lines_widest = ["1", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: one end only is taken off
# says: lines_widest: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: both ends have the same power
# says: lines_widest: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - 2*q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: the ends are added
# says: lines_widest: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) + (1-q)**n + q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: the powers of the ends exchanged for binomials
# says: lines_widest: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - n*q**n - n*(1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: padded with 2/2
# says: lines_widest: every line follows, but you leap: 1 of at least 2 lines bring something new.
lines_widest = ["2*Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,1,n-1))/2", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: padded with plus and minus the same
# says: lines_widest: every line follows, but you leap: 1 of at least 2 lines bring something new.
lines_widest = ["1 - q**n - (1-q)**n + q - q", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: the order of the ends is turned, no sum
# says: lines_widest: line 2: This line is the same as the line before: the step changes nothing
lines_widest = ["1 - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: counts turned around, then a leap
# says: lines_widest: every line follows, but none has the sum over all counts from 0 to n, to whi
lines_widest = ["Sum(binomial(n,k)*q**(n-k)*(1-q)**k, (k,1,n-1))", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: a power that is no binomial
# says: lines_widest: every line follows, but none has the sum over all counts from 0 to n, to whi
lines_widest = ["1**n - q**n - (1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: an unknown letter
# says: lines_widest: line 1: unreadable: p is not declared. This part knows the names n, k, q, la
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-p)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: the mean is claimed
# says: lines_entered: every line follows, but you leap: 1 of at least 2 lines bring something new
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam"]

# %% wrong: the constant is taken out, then a leap
# says: lines_entered: every line follows, but nothing was integrated by parts. After that step an
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["lam*Integral(t*exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: the value of the integral from a table
# says: lines_entered: every line follows, but you leap: 1 of at least 2 lines bring something new
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam - c*exp(-lam*c) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: by parts with the wrong sign
# says: lines_entered: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["c*exp(-lam*c) + Integral(exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: by parts, the minus under the integral
# says: lines_entered: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["-c*exp(-lam*c) - Integral(exp(-lam*t), (t,0,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: by parts, lam is lost
# says: lines_entered: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t)/lam, (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: integrated to infinity
# says: lines_entered: line 1: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,oo))", "(1-exp(-lam*c))/lam"]

# %% wrong: padded with a half
# says: lines_entered: every line follows, but you leap: 1 of at least 2 lines bring something new
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*lam*exp(-lam*t), (t,0,c))/2 + Integral(t*lam*exp(-lam*t), (t,0,c))/2 + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: the integral split in two, then a leap
# says: lines_entered: every line follows, but nothing was integrated by parts. After that step an
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(t*lam*exp(-lam*t), (t,0,c/2)) + Integral(t*lam*exp(-lam*t), (t,c/2,c)) + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: an integral over nothing is added
# says: lines_entered: every line follows, but nothing was integrated by parts. After that step an
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam + Integral(exp(-t), (t,0,0))", "(1-exp(-lam*c))/lam"]

# %% wrong: another integral and its value are added
# says: lines_entered: every line follows, but nothing was integrated by parts. After that step an
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(1-exp(-lam*c))/lam + Integral(exp(-t), (t,0,1)) - 1 + exp(-1)", "(1-exp(-lam*c))/lam"]

# %% wrong: an antiderivative from a table
# says: lines_entered: every line follows, but nothing was integrated by parts. After that step an
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["(-c-1/lam)*exp(-lam*c) + 1/lam + c*exp(-lam*c)", "(1-exp(-lam*c))/lam"]

# %% wrong: a fraction that is 1, to the power n
# says: lines_widest: every line follows, but none has the sum over all counts from 0 to n, to whi
lines_widest = ["(q/q)**n - q**n - (1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]

# %% wrong: ends before the last line
# says: lines_entered: the goal is not reached: the last line agrees with it, but does not have it
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "1/lam - exp(-lam*c)/lam"]

# %% wrong: the mean for ever
# says: lines_entered: line 2: wrong
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "1/lam"]

# %% wrong: what is left, not what is missing
# says: this is what is left, not what is missing
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "1 - exp(-lam*c)"

# %% wrong: in seconds
# says: this is in seconds; divide by the true mean
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)/lam"

# %% wrong: divided by the wrong mean
# says: you divided by the mean that is too small
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-lam*c)/(1 - exp(-lam*c))"

# %% wrong: the mean itself
# says: this is the mean itself
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "(1-exp(-lam*c))/lam"

# %% wrong: the sign turned
# says: the sign is turned
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "-exp(-lam*c)"

# %% wrong: for dropped runs
# says: you took the runs as dropped, not entered
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "lam*c*exp(-lam*c)/(1-exp(-lam*c))"

# %% wrong: the ratio of the means
# says: this is the ratio of the two means
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "1/(1-exp(-lam*c))"

# %% wrong: missing without lam
# says: missing: exp(-c) is not right
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-c)"

# %% wrong: an equation
# says: missing: enter the right side alone, without an equals sign and a left side.
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "missing = exp(-lam*c)"

# %% wrong: lambda by another name
# says: missing is unreadable: r is not declared. This part knows the names n, k, q, lam, t, c onl
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = "exp(-r*c)"

# %% wrong: a number
# says: missing: a string is asked, you have 0.22.
lines_widest = ["Sum(binomial(n,k)*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,c))", "(1-exp(-lam*c))/lam"]
missing = 0.22

# %% wrong: the last is missing
# says: missing: there is no answer yet. Replace the dots.
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

# %% right: factorials, all for ever minus the rest
lines_widest = ["Sum(factorial(n)/(factorial(k)*factorial(n-k))*q**k*(1-q)**(n-k), (k,0,n)) - (1-q)**n - q**n", "1 - q**n - (1-q)**n"]
lines_entered = ["Integral(exp(-lam*t), (t,0,oo)) - Integral(exp(-lam*t), (t,c,oo))", "(1-exp(-lam*c))/lam"]

# %% right: factors counted downward
lines_widest = ["Sum(binomial(n,k)*(1-q)**k*q**(n-k), (k,0,n)) - q**n - (1-q)**n", "1 - q**n - (1-q)**n"]
lines_entered = "= Integral(exp(-lam*u), (u,0,c))\n= (1-exp(-lam*c))/lam".replace("u", "t")

# %% right: SymPy objects
lam, c, t, q = sp.symbols("lam c t q", positive=True)
n = sp.Symbol("n", integer=True, positive=True)
k = sp.Symbol("k", integer=True)
whole = sp.Sum(sp.binomial(n, k) * q**k * (1 - q) ** (n - k), (k, 0, n))
lines_widest = [whole - q**n - (1 - q) ** n, 1 - q**n - (1 - q) ** n]
rest = sp.Integral(sp.exp(-lam * t), (t, 0, c))
lines_entered = [rest, (1 - sp.exp(-lam * c)) / lam]
missing = sp.exp(-lam * c)

# %% right: by x = q + 1 - q
lines_widest = """
= (q + (1-q))**n - q**n - (1-q)**n   # the theorem
= 1 - q**n - (1-q)**n
"""
lines_entered = [("Integral(exp(-lam*t), (t,0,c))", "by parts, the ends cancel"), ("(1-exp(-lam*c))/lam", "integrate")]
missing = sp.exp(-sp.Symbol("lam") * sp.Symbol("c"))

# %% right: antiderivative
lines_entered = """
= -c*exp(-lam*c) + Integral(exp(-lam*t),(t,0,c)) + c*exp(-lam*c)
= -c*exp(-lam*c) + c*exp(-lam*c) + (1 - exp(-lam*c))/lam
= (1-exp(-lam*c))/lam
"""

# %% wrong: integral computed at once, then rearranged
# says: nothing was integrated by parts
lines_entered = """
= (1 - exp(-lam*c)*(1 + lam*c))/lam + c*exp(-lam*c)
= 1/lam - exp(-lam*c)/lam
= (1-exp(-lam*c))/lam
"""

# %% wrong: a zero integral is added
# says: lines_entered: every line follows, but you leap
lines_entered = """
= Integral(exp(-lam*t),(t,0,c)) - Integral(exp(-lam*t),(t,0,c)) + (1-exp(-lam*c))/lam
= (1-exp(-lam*c))/lam
"""
