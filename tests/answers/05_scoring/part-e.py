# %% wrong: the line that carries the mistake on
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the right number, and the given line again
# says: the corrected line: this is line 4 as it stands.
corrected_line = "-Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% wrong: the right number, and the given line in another order
# says: the corrected line: this is line 4 as it stands.
corrected_line = "p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2) - Derivative(G(p), p)"

# %% wrong: the right number, with the line above copied
# says: the corrected line: this is line 3 as it stands.
corrected_line = "-Derivative(G(p), p) + Derivative(p*Derivative(G(p), p), p) - q*Derivative(G(p), p, 2)"

# %% wrong: the right number, with the line above and a zero
# says: the corrected line: this is line 3 as it stands.
corrected_line = "-Derivative(G(p), p) + Derivative(p*Derivative(G(p), p), p) - q*Derivative(G(p), p, 2) + 0"

# %% wrong: the product rule with a minus
# says: the corrected line, compared with line 3: wrong
corrected_line = "-Derivative(G(p), p) - Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% wrong: p's derivative is taken to be p
# says: the corrected line, compared with line 3: wrong
corrected_line = "-Derivative(G(p), p) + p*Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% wrong: q is differentiated as well
# says: the corrected line, compared with line 2: wrong
wrong_line = 3
corrected_line = "-Derivative(G(p), p) + Derivative(p*Derivative(G(p), p), p) - Derivative(G(p), p) - q*Derivative(G(p), p, 2)"

# %% wrong: the expected cost is suspected
# says: the corrected line, compared with line 1: wrong
wrong_line = 2
corrected_line = "Derivative(-G(p) + p*Derivative(G(p), p) + q*Derivative(G(p), p), p)"

# %% wrong: line 2 written otherwise
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
wrong_line = 2
corrected_line = "Derivative(-G(p) + (p-q)*Derivative(G(p), p), p)"

# %% wrong: line 3, as it is right
# says: the corrected line follows from line 2, but that is not all: line 3 was right as it stood.
wrong_line = 3
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the given first line
# says: the number of the line: a whole number from 2 to 5 is asked, you have 1. The first line is
wrong_line = 1
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the number only
# says: the corrected line: there is no answer yet. Replace the dots.
corrected_line = ...

# %% wrong: primes
# says: the corrected line, compared with line 3: unreadable
corrected_line = "p*G''(p) - q*G''(p)"

# %% wrong: G differentiated at q
# says: the corrected line, compared with line 3: wrong
corrected_line = "p*Derivative(G(p), p, 2) - q*Derivative(G(q), q, 2) + 1"

# %% wrong: prose
# says: the corrected line, compared with line 3: unreadable
corrected_line = "the product rule has two terms"

# %% wrong: a list of numbers
# says: the number of the line: a whole number from 2 to 5 is asked, you have [2, 3, 4, 5]. The fi
wrong_line = [2, 3, 4, 5]
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% right: the number as text
wrong_line = "4"
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% right: both terms of the product rule
corrected_line = "-Derivative(G(p), p) + Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% right: collected
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% right: second derivative written twice
corrected_line = "p*Derivative(Derivative(G(p), p), p) - q*Derivative(G(p), p, p)"

# %% wrong: the line above with its sum turned round
# says: the corrected line: this is line 3 as it stands.
corrected_line = "Derivative(p*Derivative(G(p), p), p) - (Derivative(G(p), p) + q*Derivative(G(p), p, 2))"

# %% wrong: line 2 in the place of line 4
# says: the corrected line: a sum or a product is still under a derivative in it, as in the lines
corrected_line = "Derivative((p-q)*Derivative(G(p), p) - G(p), p)"

# %% wrong: the product rule forgets the second term
# says: the corrected line, compared with line 3: wrong
corrected_line = "-Derivative(G(p), p) + Derivative(G(p), p) - q*Derivative(G(p), p, 2)"

# %% wrong: the last sign
# says: the corrected line, compared with line 3: wrong
corrected_line = "(p+q)*Derivative(G(p), p, 2)"

# %% wrong: the conclusion at p = q
# says: the corrected line, compared with line 3: wrong
corrected_line = "0"

# %% wrong: line 2, with the right end
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
wrong_line = 2
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the line numbers counted from 0
# says: the corrected line follows from line 2, but that is not all: line 3 was right as it stood.
wrong_line = 3

# %% right: diff
corrected_line = "(p-q)*diff(G(p), p, 2)"

# %% right: a SymPy object
import sympy as sp

x, y = sp.symbols("p q")
corrected_line = (x - y) * sp.Function("G")(x).diff(x, 2)

# %% right: a NumPy number, and a sign before the line
wrong_line = np.int64(4)
corrected_line = "= -diff(G(p), p) + (diff(G(p), p) + p*diff(G(p), p, p)) - q*diff(G(p), p, p)"
