# %% wrong: opens the inverse without turning the order around
# says: lines_truth: line 1: wrong
lines_truth = ["G.inv()*A.inv()*G*B", "A.inv()*B"]
lines_estimate = ["H.inv()*C.inv()*H*D", "C.inv()*D"]

# %% wrong: leaps over the opened inverse
# says: lines_truth: every line follows, but you leap
lines_truth = ["A.inv()*B"]
lines_estimate = ["C.inv()*D"]

# %% wrong: pads instead of opening the inverse
# says: none has the inverse of the product opened
lines_truth = ["A.inv()*B*G.inv()*G", "A.inv()*B"]

# %% wrong: pads on the other side
# says: none has the inverse of the product opened
lines_truth = ["(G*A).inv()*G*B*A.inv()*A", "A.inv()*B"]

# %% wrong: brackets alone, and a double inverse
# says: lines_truth: every line follows, but
lines_truth = ["(G*A).inv()*G*B", "((G*A).inv()*G*B).inv().inv()", "A.inv()*B"]

# %% wrong: only the truth is moved
# says: lines_estimate: every line follows, but you leap
lines_estimate = ["C.inv()*D"]

# %% wrong: the lines of the other chain
# says: lines_estimate: line 1: wrong
lines_estimate = ["A.inv()*G.inv()*G*B", "A.inv()*B"]

# %% wrong: ends with the motion from B to A
# says: lines_truth: line 2: wrong
lines_truth = ["A.inv()*G.inv()*G*B", "B.inv()*A"]

# %% wrong: stops before canceling
# says: the goal is not reached
lines_truth = ["A.inv()*G.inv()*G*B"]
lines_estimate = ["C.inv()*H.inv()*H*D"]

# %% wrong: writes a transpose for the inverse
# says: lines_truth: line 1: wrong
lines_truth = ["A.T*G.T*G*B", "A.inv()*B"]

# %% wrong: says that the body frame does not matter either
# says: you took it for a motion of the world
E_body = "E"

# %% wrong: conjugates the other way round
# says: M and its inverse are swapped
E_body = "M*E*M.inv()"

# %% wrong: changes the body frame of the ends only
# says: one end is missing
E_body = "E*M"

# %% wrong: changes the start only
# says: the other end is missing
E_body = "M.inv()*E"

# %% wrong: no inverse
# says: M stands on both sides without an inverse
E_body = "M*E*M"

# %% wrong: the inverse of it
# says: this is the inverse of the new E
E_body = "M.inv()*E.inv()*M"

# %% wrong: M inverted on both sides
# says: M is inverted on both sides
E_body = "M.inv()*E*M.inv()"

# %% wrong: with the poses themselves
# says: write it with E and M alone
E_body = "((A*M).inv()*(B*M)).inv()*((C*M).inv()*(D*M))"

# %% right: starts with the given line, writes the bracket of the identity
lines_truth = ["(G*A).inv()*(G*B)", "A.inv()*G.inv()*G*B", "A.inv()*(G.inv()*G)*B", "A.inv()*B"]
E_body = "(E.inv()*M).inv()*M"

# %% right: a line more, and E written as the inverse of an inverse
lines_truth = ["A.inv()*G.inv()*(G*B)", "A.inv()*G.inv()*G*B", "A.inv()*B"]
E_body = "(M.inv()*E.inv()*M).inv()"

# %% right: pairs of line and reason
lines_truth = [("A.inv()*G.inv()*G*B", "socks"), ("A.inv()*B", "cancel")]
lines_estimate = [("C.inv()*H.inv()*H*D", "same"), ("C.inv()*D", "same")]

# %% right: the written form, brackets first
lines_truth = """
    = (G*A).inv()*G*B        # associative
    = A.inv()*G.inv()*G*B    # shoes before socks
    = A.inv()*B              # they cancel
"""
lines_estimate = """
C.inv()*H.inv()*H*D
C.inv()*D
"""
E_body = "M**-1*E*M"

# %% right: powers, and letters that the setup uses
A = B = check = 3
lines_truth = ["A**-1*G**-1*G*B", "A**-1*B"]
E_body = "M.inv()*(E*M)"

# %% right: a bracket around the opened inverse, E as SymPy's object
import sympy as sp
E, M = sp.MatrixSymbol("E", 3, 3), sp.MatrixSymbol("M", 3, 3)
lines_truth = ["(A.inv()*G.inv())*(G*B)", "A.inv()*B"]
E_body = M.inv() * E * M
