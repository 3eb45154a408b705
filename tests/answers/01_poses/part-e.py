# %% wrong: asserts nothing
# says: use assert instead
def catches_bad_wrap(wrap):
    return all(-np.pi <= wrap(a) < np.pi for a in (0.0, 4.0, -4.0))

# %% wrong: one angle
# says: takes off one turn at most
def catches_bad_wrap(wrap):
    assert np.isclose(wrap(4.0), 4.0 - 2 * np.pi)

# %% wrong: the interval only
# says: takes off half turns
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi

# %% wrong: the direction only
# says: accepts an implementation that does nothing
def catches_bad_wrap(wrap):
    for a in np.linspace(-40, 40, 999):
        assert np.isclose(np.cos(wrap(a)), np.cos(a)) and np.isclose(np.sin(wrap(a)), np.sin(a))

# %% wrong: closed on both sides
# says: leaves the interval for +pi
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert abs(wrap(a)) <= np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: never tries the float below -pi
# says: for the number just below -pi
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi]:
        assert -np.pi <= wrap(a) < np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: within one turn only
# says: takes off one turn at most
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-6, 6, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: the other end of the interval is closed
# says: rejects an implementation that is right
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi < wrap(a) <= np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: asks for equality to the last bit
# says: rejects an implementation that is right
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi
        assert np.exp(1j * wrap(a)) == np.exp(1j * a)

# %% wrong: tests its own wrap
# says: never calls what it is to test
def catches_bad_wrap(wrap):
    for a in np.linspace(-40, 40, 999):
        assert -np.pi <= am.wrap(a) < np.pi

# %% wrong: on arrays only
# says: is right for arrays and does nothing to a single number
def catches_bad_wrap(wrap):
    a = np.concatenate([np.linspace(-50, 50, 2001), [-np.pi, np.pi, np.nextafter(-np.pi, -4)]])
    b = wrap(a)
    assert (b >= -np.pi).all() and (b < np.pi).all()
    assert np.allclose(np.cos(a), np.cos(b)) and np.allclose(np.sin(a), np.sin(b))

# %% wrong: on single numbers only
# says: is right for single numbers and does nothing to an array
def catches_bad_wrap(wrap):
    for angle in (0.0, 3.0, -3.0, 4.0, 10.0, -10.0, 100.0, np.pi, -np.pi, np.nextafter(-np.pi, -4)):
        wrapped = float(wrap(angle))
        turns = (angle - wrapped) / (2 * np.pi)
        assert abs(turns - round(turns)) < 1e-9, angle
        assert not wrapped >= np.pi and not wrapped < -np.pi, angle

# %% wrong: an array is tried, but only inside
# says: is right for single numbers and does nothing to an array
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9
    assert np.allclose(wrap(np.array([0.1, -0.2])), [0.1, -0.2])

# %% wrong: only cosines are compared
# says: only cosines agree
def catches_bad_wrap(wrap):
    a = np.concatenate([np.linspace(-40, 40, 999), [np.pi, -np.pi, np.nextafter(-np.pi, -4)]])
    for w in (wrap(a), np.array([wrap(x) for x in a])):
        assert np.all(w >= -np.pi) and np.all(w < np.pi)
        assert np.allclose(np.cos(w), np.cos(a))

# %% wrong: only the range at the ends, and a few numbers
# says: takes off one turn at most
def catches_bad_wrap(wrap):
    for x in (np.pi, -np.pi, np.nextafter(-np.pi, -4)):
        assert -np.pi <= wrap(x) < np.pi
    assert np.isclose(wrap(9.0), 9 - 2 * np.pi) and np.isclose(wrap(2.0), 2)

# %% wrong: the range at the ends, and a few numbers, each in both kinds
# says: accepts an implementation that loses the sign
def catches_bad_wrap(wrap):
    for x in (np.pi, -np.pi, np.nextafter(-np.pi, -4)):
        assert -np.pi <= wrap(x) < np.pi
    for x in (9.0, 2.0, 20.0):
        right = np.angle(np.exp(1j * x))
        assert np.isclose(wrap(x), right) and np.isclose(wrap(np.array([x]))[0], right)

# %% wrong: only sines are compared
# says: takes off half turns
def catches_bad_wrap(wrap):
    a = np.concatenate([np.linspace(-40, 40, 999), [np.pi, -np.pi, np.nextafter(-np.pi, -4)]])
    for w in (wrap(a), np.array([wrap(x) for x in a])):
        assert np.all(w >= -np.pi) and np.all(w < np.pi)
        assert np.allclose(np.abs(np.sin(w)), np.abs(np.sin(a)))

# %% wrong: refuses everything
# says: rejects an implementation that is right
def catches_bad_wrap(wrap):
    wrap(1.0)
    raise AssertionError

# %% wrong: looks at the name
# says: rejects an implementation that is right
def catches_bad_wrap(wrap):
    assert wrap.__name__ == "wrap"

# %% wrong: raises what is no AssertionError
# says: It should end with a failed assertion
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        for w in (wrap(a), wrap(np.array([a]))[0]):
            if not -np.pi <= w < np.pi or abs(np.exp(1j * w) - np.exp(1j * a)) > 1e-9:
                raise ValueError(a)

# %% right: on arrays, and one by one
def catches_bad_wrap(wrap):
    a = np.concatenate([np.linspace(-50, 50, 2001), [-np.pi, np.pi, np.nextafter(-np.pi, -4)]])
    for b in (wrap(a), np.array([wrap(x) for x in a])):
        assert (b >= -np.pi).all() and (b < np.pi).all()
        assert np.allclose(np.cos(a), np.cos(b)) and np.allclose(np.sin(a), np.sin(b))

# %% right: by whole turns, few numbers
def catches_bad_wrap(wrap):
    numbers = (0.0, 3.0, -3.0, 4.0, -4.0, 10.0, -10.0, 100.0, np.pi, -np.pi, np.nextafter(-np.pi, -4))
    for angle in numbers:
        wrapped = float(wrap(angle))
        turns = (angle - wrapped) / (2 * np.pi)
        assert abs(turns - round(turns)) < 1e-9, angle
        assert not wrapped >= np.pi and not wrapped < -np.pi, angle
    assert np.allclose(wrap(np.array(numbers)), [wrap(x) for x in numbers])

# %% right: compared with the library, to rounding, and the interval by itself
def catches_bad_wrap(wrap):
    a = np.r_[np.linspace(-40, 40, 777), np.pi, -np.pi, np.nextafter(-np.pi, -4)]
    assert np.allclose(wrap(a), am.wrap(a), atol=1e-9)
    assert ((wrap(a) >= -np.pi) & (wrap(a) < np.pi)).all()
    for x in a:
        w = wrap(float(x))
        assert np.isclose(w, am.wrap(x))
        assert -np.pi <= w < np.pi

# %% right: random turns, a helper, an angle of a quotient
def inside(w):
    return (w >= -np.pi) & (w < np.pi)
def catches_bad_wrap(wrap):
    rng = np.random.default_rng(3)
    a = np.append(rng.uniform(-60, 60, 500), [np.pi, -np.pi, np.nextafter(-np.pi, -4)])
    w = np.asarray(wrap(a))
    assert w.shape == a.shape, "shape"
    assert inside(w).all(), "outside"
    assert (np.abs(np.angle(np.exp(1j * (w - a)))) < 1e-6).all(), "direction"
    for x in a.tolist():
        y = wrap(x)
        assert inside(y), x
        assert abs(np.angle(np.exp(1j * (y - x)))) < 1e-6, x

# %% right: raises by hand
def catches_bad_wrap(wrap):
    numbers = [k * 0.37 for k in range(-80, 81)] + [np.pi, -np.pi, np.nextafter(-np.pi, -4)]
    together = wrap(np.array(numbers))
    for a, b in zip(numbers, together):
        for w in (wrap(a), b):
            if w < -np.pi or w >= np.pi or abs(np.remainder(w - a + 1, 2 * np.pi) - 1) > 1e-8:
                raise AssertionError(f"{a} becomes {w}")

# %% right: an array with two axes
def catches_bad_wrap(wrap):
    a = np.linspace(-20, 20, 402).reshape(2, -1)
    a[0, :3] = np.pi, -np.pi, np.nextafter(-np.pi, -4)
    w = wrap(a)
    assert w.shape == a.shape
    assert ((w >= -np.pi) & (w < np.pi)).all()
    assert np.allclose(np.exp(1j * w), np.exp(1j * a))
    v = [wrap(x) for x in a.ravel()]
    assert all(-np.pi <= x < np.pi for x in v)
    assert np.allclose(np.exp(1j * np.array(v)), np.exp(1j * a.ravel()))
