# %% wrong: the line that carries the mistake on
wrong_line = 5
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the right number, and the given line again
wrong_line = 4
corrected_line = "-Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% wrong: the right number, and the given line in another order
wrong_line = 4
corrected_line = "p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2) - Derivative(G(p), p)"

# %% wrong: the right number, with the line above copied
wrong_line = 4
corrected_line = "-Derivative(G(p), p) + Derivative(p*Derivative(G(p), p), p) - q*Derivative(G(p), p, 2)"

# %% wrong: the right number, with the line above and a zero
wrong_line = 4
corrected_line = "-Derivative(G(p), p) + Derivative(p*Derivative(G(p), p), p) - q*Derivative(G(p), p, 2) + 0"

# %% wrong: the product rule with a minus
wrong_line = 4
corrected_line = "-Derivative(G(p), p) - Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% wrong: p's derivative is taken to be p
wrong_line = 4
corrected_line = "-Derivative(G(p), p) + p*Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% wrong: q is differentiated as well
wrong_line = 3
corrected_line = "-Derivative(G(p), p) + Derivative(p*Derivative(G(p), p), p) - Derivative(G(p), p) - q*Derivative(G(p), p, 2)"

# %% wrong: the expected cost is suspected
wrong_line = 2
corrected_line = "Derivative(-G(p) + p*Derivative(G(p), p) + q*Derivative(G(p), p), p)"

# %% wrong: line 2 written otherwise
wrong_line = 2
corrected_line = "Derivative(-G(p) + (p-q)*Derivative(G(p), p), p)"

# %% wrong: line 3, as it is right
wrong_line = 3
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the given first line
wrong_line = 1
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the number only
wrong_line = 4
corrected_line = ...

# %% wrong: primes
wrong_line = 4
corrected_line = "p*G''(p) - q*G''(p)"

# %% wrong: G differentiated at q
wrong_line = 4
corrected_line = "p*Derivative(G(p), p, 2) - q*Derivative(G(q), q, 2) + 1"

# %% wrong: prose
wrong_line = 4
corrected_line = "the product rule has two terms"

# %% wrong: a list of numbers
wrong_line = [2, 3, 4, 5]
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% wrong: the number as text
wrong_line = "4"
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% right: both terms of the product rule
wrong_line = 4
corrected_line = "-Derivative(G(p), p) + Derivative(G(p), p) + p*Derivative(G(p), p, 2) - q*Derivative(G(p), p, 2)"

# %% right: collected
wrong_line = 4
corrected_line = "(p-q)*Derivative(G(p), p, 2)"

# %% right: second derivative written twice
wrong_line = 4
corrected_line = "p*Derivative(Derivative(G(p), p), p) - q*Derivative(G(p), p, p)"
