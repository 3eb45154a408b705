# %% wrong: the order of the inverse is suspected
# says: the corrected line, compared with line 1: wrong
wrong_line = 2
corrected_line = "Z.inv()*X_i.inv()*D.inv()*X_j"

# %% wrong: the line that carries the mistake on
# says: the corrected line equals line 1, as it should. But line 4, which you blame, does follow f
wrong_line = 4
corrected_line = "Z.inv()*X_i.inv()*X_j*((X_j.inv()*X_i)*D*(X_i.inv()*X_j)).inv()"

# %% wrong: the last line
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5
corrected_line = "Z.inv()*X_i.inv()*X_j*((X_j.inv()*X_i)*D*(X_j.inv()*X_i).inv()).inv()"

# %% wrong: the right number, and the given line again
# says: the corrected line: this is line 3 as it stands.
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_i.inv()*X_j)*D.inv()*(X_j.inv()*X_i)"

# %% wrong: the right number, and the line above
# says: the corrected line: this is line 2 as it stands.
corrected_line = "Z.inv()*D.inv()*X_i.inv()*X_j"

# %% wrong: the right number, and the line above with brackets
# says: the corrected line: it follows, but D still stands in front. Bring it behind the first X_j
corrected_line = "Z.inv()*D.inv()*(X_i.inv()*X_j)"

# %% wrong: the line above with an identity behind it
# says: the corrected line: it follows, but D still stands in front. Bring it behind the first X_j
corrected_line = "Z.inv()*D.inv()*X_i.inv()*X_j*(X_j.inv()*X_j)"

# %% wrong: the line above with an identity in front of D
# says: the corrected line: it follows, but D still stands in front. Bring it behind the first X_j
corrected_line = "Z.inv()*X_i.inv()*X_i*D.inv()*X_i.inv()*X_j"

# %% wrong: the line above with an identity in front of all
# says: the corrected line: it follows, but D still stands in front. Bring it behind the first X_j
corrected_line = "X_j*X_j.inv()*Z.inv()*D.inv()*X_i.inv()*X_j"

# %% wrong: the right number, with a bracket that has no inverse behind D
# says: the corrected line, compared with line 2: wrong
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_j.inv()*X_i)"

# %% wrong: D commutes with the poses
# says: the corrected line, compared with line 2: wrong
corrected_line = "Z.inv()*X_i.inv()*X_j*D.inv()"

# %% wrong: D without its inverse
# says: the corrected line, compared with line 2: wrong
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D*(X_i.inv()*X_j)"

# %% wrong: the given first line
# says: the number of the line: a whole number from 2 to 5 is asked, you have 1. The first line is
wrong_line = 1

# %% wrong: prose
# says: the corrected line, compared with line 2: unreadable: cannot be read: invalid syntax
corrected_line = "the adjoint goes the wrong way"

# %% wrong: all lines from the third on
# says: the number of the line: a whole number from 2 to 5 is asked, you have [3, 4, 5]. The first
wrong_line = [3, 4, 5]

# %% wrong: the Jacobian of the blog
# says: this is the blog's: Ad of the way from X_i to X_j
J = [[-1, 0, -3], [0, -1, 4], [0, 0, -1]]

# %% wrong: the sign of the inverse is lost
# says: the sign is lost
J = [[1, 0, -3], [0, 1, 4], [0, 0, 1]]

# %% wrong: no lever
# says: a turn of X_i moves nothing: the lever is left out
J = -np.eye(3)

# %% wrong: the Jacobian at j
# says: this is the Jacobian at the other node
J = np.eye(3)

# %% wrong: transposed
# says: rows and columns are swapped
J = [[-1, 0, 0], [0, -1, 0], [3, -4, -1]]

# %% wrong: x and y of the lever have changed places
# says: the parts of the lever have changed places
J = [[-1, 0, 4], [0, -1, -3], [0, 0, -1]]

# %% wrong: the rows of positions only
# says: J: shape (3, 3) is asked, you have [[-1, 0, 3], [0, -1, -4]].
J = [[-1, 0, 3], [0, -1, -4]]

# %% wrong: no Jacobian
# says: J: there is no answer yet. Replace the dots.
J = ...

# %% wrong: the number only
# says: the corrected line: there is no answer yet. Replace the dots.
corrected_line = ...

# %% wrong: the names of one node and the other have changed places
# says: the corrected line, compared with line 2: wrong
corrected_line = "Z.inv()*X_j.inv()*X_i*(X_i.inv()*X_j)*D.inv()*(X_j.inv()*X_i)"

# %% wrong: the letters of other notes
# says: the corrected line, compared with line 2: unreadable: Y is not declared. This part knows t
corrected_line = "Z.inv()*X.inv()*Y*(Y.inv()*X)*D.inv()*(X.inv()*Y)"

# %% right: without brackets
corrected_line = "Z.inv()*X_i.inv()*X_j*X_j.inv()*X_i*D.inv()*X_i.inv()*X_j"
J = np.array([[-1, 0, 3], [0, -1, -4], [0, 0, -1]])

# %% right: one bracket and its inverse
import sympy as sp

wrong_line = np.int64(3)
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_j.inv()*X_i).inv()"
J = sp.Matrix([[-1, 0, 3], [0, -1, -4], [0, 0, -1]])

# %% right: inv as a function, the inverse outside
corrected_line = "inv(Z)*inv(X_i)*X_j*inv(inv(X_j)*X_i*D*inv(X_i)*X_j)"
graph = am.PoseGraph(am.planar_poses([[0, 0], [4, 3]], [0, 0]), [[0, 1]], am.planar_poses([[4, 3]], [0]), np.eye(3))
J = graph.jacobians()[0][0]

# %% right: NumPy's product, Jacobian from differences
corrected_line = "(X_i @ Z).inv() @ X_j @ (X_i.inv() @ X_j).inv() @ D.inv() @ (X_i.inv() @ X_j)"
X, Z, h = am.planar_poses([[0, 0], [4, 3]], [0, 0]), am.planar_poses([[4, 3]], [0]), 1e-6
J = np.zeros((3, 3))
for column in range(3):
    d = np.eye(3)[column] * h
    ends = []
    for sign in (1, -1):
        Y = X.copy()
        Y[0] = Y[0] @ am.planar_poses([sign * d[:2]], sign * d[2:])[0]
        ends.append(am.PoseGraph(Y, [[0, 1]], Z, np.eye(3)).residuals()[0])
    J[:, column] = (ends[0] - ends[1]) / (2 * h)

# %% right: a tuple of tuples
corrected_line = "Z.inv()*(X_i.inv()*X_j)*((X_i.inv()*X_j).inv()*D.inv()*(X_i.inv()*X_j))"
J = ((-1.0, 0.0, 3.0), (0.0, -1.0, -4.0), (0.0, 0.0, -1.0))

# %% right: the bracket as an inverse
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_i.inv()*X_j).inv()*D.inv()*X_i.inv()*X_j"
J = [[-1.0, 0, 3.0], [0, -1.0, -4.0], [0, 0, -1.0]]

# %% right: text number, other brackets, array
wrong_line = "3"
corrected_line = "Z.inv()*X_i.inv()*X_j*X_j.inv()*X_i*D.inv()*X_i.inv()*X_j"
J = np.array([[-1.0, 0, 3], [0, -1, -4], [0, 0, -1]])

# %% right: SymPy matrix
J = sp.Matrix([[-1, 0, 3], [0, -1, -4], [0, 0, -1]])
corrected_line = "= Z.inv()*X_i.inv()*X_j*(X_i.inv()*X_j).inv()*D.inv()*(X_i.inv()*X_j)"
