# %% wrong: opens the inverse without turning the order around
lines_truth = ["G.inv()*A.inv()*G*B", "A.inv()*B"]
lines_estimate = ["H.inv()*C.inv()*H*D", "C.inv()*D"]
E_body = "M.inv()*E*M"
# %% wrong: leaps over the opened inverse
lines_truth = ["A.inv()*B"]
lines_estimate = ["C.inv()*D"]
E_body = "M.inv()*E*M"
# %% wrong: only the truth is moved
lines_truth = ["A.inv()*G.inv()*G*B", "A.inv()*B"]
lines_estimate = ["C.inv()*D"]
E_body = "M.inv()*E*M"
# %% wrong: ends with the motion from B to A
lines_truth = ["A.inv()*G.inv()*G*B", "B.inv()*A"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "M.inv()*E*M"
# %% wrong: stops before canceling
lines_truth = ["A.inv()*G.inv()*G*B"]
lines_estimate = ["C.inv()*H.inv()*H*D"]
E_body = "M.inv()*E*M"
# %% wrong: says that the body frame does not matter either
lines_truth = ["A.inv()*G.inv()*G*B", "A.inv()*B"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "E"
# %% wrong: conjugates the other way round
lines_truth = ["A.inv()*G.inv()*G*B", "A.inv()*B"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "M*E*M.inv()"
# %% wrong: changes the body frame of the ends only
lines_truth = ["A.inv()*G.inv()*G*B", "A.inv()*B"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "E*M"
# %% wrong: writes a transpose for the inverse
lines_truth = ["A.T*G.T*G*B", "A.inv()*B"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "M.inv()*E*M"
# %% right: starts with the given line, writes the bracket of the identity
lines_truth = ["(G*A).inv()*(G*B)", "A.inv()*G.inv()*G*B", "A.inv()*(G.inv()*G)*B", "A.inv()*B"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "(E.inv()*M).inv()*M"
# %% right: a line more, and E written as the inverse of an inverse
lines_truth = ["A.inv()*G.inv()*(G*B)", "A.inv()*G.inv()*G*B", "A.inv()*B"]
lines_estimate = ["C.inv()*H.inv()*H*D", "C.inv()*D"]
E_body = "(M.inv()*E.inv()*M).inv()"
