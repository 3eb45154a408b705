# %% wrong: the line that carries the mistake on
wrong_line = 5
corrected_line = "Q*(s - A/Q)**2 + (P*Q - A**2)/Q"

# %% wrong: the right number, and the given line again
wrong_line = 4
corrected_line = "Q*(s - A/Q)**2 - A**2/Q**2 + P"

# %% wrong: the right number, with the sign changed instead of the factor
wrong_line = 4
corrected_line = "Q*(s - A/Q)**2 + A**2/Q**2 + P"

# %% wrong: the right number, with the line above copied
wrong_line = 4
corrected_line = "Q*((s - A/Q)**2 - A**2/Q**2) + P"

# %% wrong: the right number, with the line above in another order
wrong_line = 4
corrected_line = "P + (-A**2/Q**2 + (s - A/Q)**2)*Q"

# %% wrong: the right number, with the first line copied
wrong_line = 4
corrected_line = "P - 2*s*A + s**2*Q"

# %% wrong: the right number, with the second line in another order copied
wrong_line = 4
corrected_line = "P + (s**2 - 2*A*s/Q)*Q"

# %% wrong: the right number, with the last line copied
wrong_line = 4
corrected_line = "Q*(s - A/Q)**2 + P*(1 - A**2/(P*Q**2))"

# %% wrong: a line that was right, rewritten
wrong_line = 3
corrected_line = "P + Q*(s - A/Q)**2 - A**2/Q"

# %% wrong: a line that was right, copied
wrong_line = 2
corrected_line = "Q*(s**2 - 2*s*A/Q) + P"

# %% wrong: the last line
wrong_line = 6
corrected_line = "Q*(s - A/Q)**2 + P*(1 - A**2/(P*Q))"

# %% wrong: the given first line
wrong_line = 1
corrected_line = "P - 2*s*A + s**2*Q"

# %% wrong: the number only
wrong_line = 4
corrected_line = ...

# %% wrong: the number as a text
wrong_line = "4"
corrected_line = "Q*(s - A/Q)**2 - A**2/Q + P"

# %% wrong: prose
wrong_line = 4
corrected_line = "the factor Q is missing"

# %% wrong: a product without its sign
wrong_line = 4
corrected_line = "Q(s - A/Q)**2 - A**2/Q + P"

# %% wrong: an equation
wrong_line = 4
corrected_line = "Eq(J, Q*(s - A/Q)**2 - A**2/Q + P)"

# %% wrong: no such line
wrong_line = 7
corrected_line = "0"

# %% wrong: a list of all numbers
wrong_line = [2, 3, 4, 5, 6]
corrected_line = "Q*(s - A/Q)**2 - A**2/Q + P"

# %% right: the factor written out
wrong_line = 4
corrected_line = "Q*(s - A/Q)**2 - Q*(A**2/Q**2) + P"

# %% right: another order, with powers
wrong_line = 4
corrected_line = "P + Q*(s - A*Q**(-1))**2 - A**2*Q**(-1)"
