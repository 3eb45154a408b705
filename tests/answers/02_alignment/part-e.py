# %% wrong: the line that carries the mistake on
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5
corrected_line = "Q*(s - A/Q)**2 + (P*Q - A**2)/Q"

# %% wrong: the right number, and the given line again
# says: the corrected line: this is line 4 as it stands.
corrected_line = "Q*(s - A/Q)**2 - A**2/Q**2 + P"

# %% wrong: the right number, with the sign changed instead of the factor
# says: the corrected line, compared with line 3: wrong: at P = 1, Q = 1, A = 1, s = 1 the line be
corrected_line = "Q*(s - A/Q)**2 + A**2/Q**2 + P"

# %% wrong: the right number, with the line above copied
# says: the corrected line: this is line 3 as it stands.
corrected_line = "Q*((s - A/Q)**2 - A**2/Q**2) + P"

# %% wrong: the right number, with the line above in another order
# says: the corrected line: this is line 3 as it stands.
corrected_line = "P + (-A**2/Q**2 + (s - A/Q)**2)*Q"

# %% wrong: the right number, with the first line copied
# says: the corrected line: this is line 1 as it stands.
corrected_line = "P - 2*s*A + s**2*Q"

# %% wrong: the right number, with the second line in another order copied
# says: the corrected line: this is line 2 as it stands.
corrected_line = "P + (s**2 - 2*A*s/Q)*Q"

# %% wrong: the right number, with the last line copied
# says: the corrected line: this is line 6 as it stands.
corrected_line = "Q*(s - A/Q)**2 + P*(1 - A**2/(P*Q**2))"

# %% wrong: a line that was right, rewritten
# says: the corrected line follows from line 2, but that is not all: line 3 was right as it stood.
wrong_line = 3
corrected_line = "P + Q*(s - A/Q)**2 - A**2/Q"

# %% wrong: a line that was right, copied
# says: the corrected line: this is line 2 as it stands.
wrong_line = 2
corrected_line = "Q*(s**2 - 2*s*A/Q) + P"

# %% wrong: the last line
# says: the corrected line equals line 1, as it should. But line 6, which you blame, does follow f
wrong_line = 6
corrected_line = "Q*(s - A/Q)**2 + P*(1 - A**2/(P*Q))"

# %% wrong: the given first line
# says: the number of the line: a whole number from 2 to 6 is asked, you have 1. The first line is
wrong_line = 1
corrected_line = "P - 2*s*A + s**2*Q"

# %% wrong: the number only
# says: the corrected line: there is no answer yet. Replace the dots.
corrected_line = ...

# %% wrong: prose
# says: the corrected line, compared with line 3: unreadable: cannot be read: invalid syntax
corrected_line = "the factor Q is missing"

# %% wrong: a product without its sign
# says: the corrected line, compared with line 3: unreadable: Q is not a function: write Q*(...) f
corrected_line = "Q(s - A/Q)**2 - A**2/Q + P"

# %% wrong: an equation
# says: the corrected line, compared with line 3: unreadable: J is not declared. This part knows t
corrected_line = "Eq(J, Q*(s - A/Q)**2 - A**2/Q + P)"

# %% wrong: no such line
# says: the number of the line: a whole number from 2 to 6 is asked, you have 7. The first line is
wrong_line = 7
corrected_line = "0"

# %% wrong: a list of all numbers
# says: the number of the line: a whole number from 2 to 6 is asked, you have [2, 3, 4, 5, 6]. The
wrong_line = [2, 3, 4, 5, 6]

# %% right: the factor written out
corrected_line = "Q*(s - A/Q)**2 - Q*(A**2/Q**2) + P"

# %% right: another order, with powers
corrected_line = "P + Q*(s - A*Q**(-1))**2 - A**2*Q**(-1)"

# %% wrong: Q twice below
# says: the corrected line, compared with line 3: wrong: at P = 1, Q = 2, A = 1, s = 1 the line be
corrected_line = "Q*(s - A/Q)**2 - A**2/Q**3 + P"

# %% wrong: the whole bracket multiplied twice
# says: the corrected line, compared with line 3: wrong: at P = 1, Q = 2, A = 1, s = 1 the line be
corrected_line = "Q*(s - A/Q)**2 - A**2 + P"

# %% wrong: a sum of squares
# says: the corrected line, compared with line 3: wrong: at P = 1, Q = 1, A = 2, s = 1 the line be
corrected_line = "Q*(s**2 - A**2/Q**2) - A**2/Q + P"

# %% right: the number as text, the line with a sign
wrong_line = "4"
corrected_line = "= Q*(s - A/Q)**2 - A**2/Q + P"

# %% right: a SymPy object, letters used up
import sympy

P, Q, A, s = sympy.symbols("P Q A s", positive=True)
wrong_line = np.int64(4)
corrected_line = Q * (s - A / Q) ** 2 - A**2 / Q + P

# %% right: a number that is a float, over one denominator below
wrong_line = 4.0
corrected_line = "Q*(s - A/Q)**2 + (P*Q - A**2)/Q"
