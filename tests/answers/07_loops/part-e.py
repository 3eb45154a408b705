# %% wrong: the order of the inverse is suspected
wrong_line = 2
corrected_line = "Z.inv()*X_i.inv()*D.inv()*X_j"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the line that carries the mistake on
wrong_line = 4
corrected_line = "Z.inv()*X_i.inv()*X_j*((X_j.inv()*X_i)*D*(X_i.inv()*X_j)).inv()"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the last line
wrong_line = 5
corrected_line = "Z.inv()*X_i.inv()*X_j*((X_j.inv()*X_i)*D*(X_j.inv()*X_i).inv()).inv()"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the right number, and the given line again
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_i.inv()*X_j)*D.inv()*(X_j.inv()*X_i)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the right number, and the line above
wrong_line = 3
corrected_line = "Z.inv()*D.inv()*X_i.inv()*X_j"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the right number, and the line above with brackets
wrong_line = 3
corrected_line = "Z.inv()*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the line above with an identity behind it
wrong_line = 3
corrected_line = "Z.inv()*D.inv()*X_i.inv()*X_j*(X_j.inv()*X_j)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the line above with an identity in front of D
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_i*D.inv()*X_i.inv()*X_j"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the line above with an identity in front of all
wrong_line = 3
corrected_line = "X_j*X_j.inv()*Z.inv()*D.inv()*X_i.inv()*X_j"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the right number, with a bracket that has no inverse behind D
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_j.inv()*X_i)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: D commutes with the poses
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*D.inv()"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: D without its inverse
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D*(X_i.inv()*X_j)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the given first line
wrong_line = 1
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: prose
wrong_line = 3
corrected_line = "the adjoint goes the wrong way"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: all lines from the third on
wrong_line = [3, 4, 5]
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the Jacobian of the blog
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, -3], [0, -1, 4], [0, 0, -1]]

# %% wrong: the sign of the inverse is lost
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[1, 0, -3], [0, 1, 4], [0, 0, 1]]

# %% wrong: no lever
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = -np.eye(3)

# %% wrong: the Jacobian at j
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = np.eye(3)

# %% wrong: transposed
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, 0], [0, -1, 0], [3, -4, -1]]

# %% wrong: x and y of the lever have changed places
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, 4], [0, -1, -3], [0, 0, -1]]

# %% wrong: the rows of positions only
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = [[-1, 0, 3], [0, -1, -4]]

# %% wrong: no Jacobian
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_i.inv()*X_j)"
J = ...

# %% wrong: the number only
wrong_line = 3
corrected_line = ...
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the names of one node and the other have changed places
wrong_line = 3
corrected_line = "Z.inv()*X_j.inv()*X_i*(X_i.inv()*X_j)*D.inv()*(X_j.inv()*X_i)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% wrong: the letters of other notes
wrong_line = 3
corrected_line = "Z.inv()*X.inv()*Y*(Y.inv()*X)*D.inv()*(X.inv()*Y)"
J = [[-1, 0, 3], [0, -1, -4], [0, 0, -1]]

# %% right: without brackets
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*X_j.inv()*X_i*D.inv()*X_i.inv()*X_j"
J = np.array([[-1, 0, 3], [0, -1, -4], [0, 0, -1]])

# %% right: one bracket and its inverse
import sympy as sp

wrong_line = np.int64(3)
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_j.inv()*X_i)*D.inv()*(X_j.inv()*X_i).inv()"
J = sp.Matrix([[-1, 0, 3], [0, -1, -4], [0, 0, -1]])

# %% right: inv as a function, the inverse outside
wrong_line = 3
corrected_line = "inv(Z)*inv(X_i)*X_j*inv(inv(X_j)*X_i*D*inv(X_i)*X_j)"
graph = am.PoseGraph(am.planar_poses([[0, 0], [4, 3]], [0, 0]), [[0, 1]], am.planar_poses([[4, 3]], [0]), np.eye(3))
J = graph.jacobians()[0][0]

# %% right: NumPy's product, Jacobian from differences
wrong_line = 3
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
wrong_line = 3
corrected_line = "Z.inv()*(X_i.inv()*X_j)*((X_i.inv()*X_j).inv()*D.inv()*(X_i.inv()*X_j))"
J = ((-1.0, 0.0, 3.0), (0.0, -1.0, -4.0), (0.0, 0.0, -1.0))

# %% right: the bracket as an inverse
wrong_line = 3
corrected_line = "Z.inv()*X_i.inv()*X_j*(X_i.inv()*X_j).inv()*D.inv()*X_i.inv()*X_j"
J = [[-1.0, 0, 3.0], [0, -1.0, -4.0], [0, 0, -1.0]]
