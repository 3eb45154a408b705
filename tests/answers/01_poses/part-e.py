# %% wrong: asserts nothing
def catches_bad_wrap(wrap):
    return all(-np.pi <= wrap(a) < np.pi for a in (0.0, 4.0, -4.0))

# %% wrong: one angle
def catches_bad_wrap(wrap):
    assert np.isclose(wrap(4.0), 4.0 - 2 * np.pi)

# %% wrong: the interval only
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi

# %% wrong: the direction only
def catches_bad_wrap(wrap):
    for a in np.linspace(-40, 40, 999):
        assert np.isclose(np.cos(wrap(a)), np.cos(a)) and np.isclose(np.sin(wrap(a)), np.sin(a))

# %% wrong: closed on both sides
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert abs(wrap(a)) <= np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: never tries the float below -pi
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi]:
        assert -np.pi <= wrap(a) < np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: within one turn only
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-6, 6, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: the other end of the interval is closed
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi < wrap(a) <= np.pi
        assert abs(np.exp(1j * wrap(a)) - np.exp(1j * a)) < 1e-9

# %% wrong: asks for equality to the last bit
def catches_bad_wrap(wrap):
    for a in [*np.linspace(-40, 40, 999), -np.pi, np.pi, np.nextafter(-np.pi, -9)]:
        assert -np.pi <= wrap(a) < np.pi
        assert np.exp(1j * wrap(a)) == np.exp(1j * a)

# %% wrong: tests its own wrap
def catches_bad_wrap(wrap):
    for a in np.linspace(-40, 40, 999):
        assert -np.pi <= am.wrap(a) < np.pi

# %% right: on arrays
def catches_bad_wrap(wrap):
    a = np.concatenate([np.linspace(-50, 50, 2001), [-np.pi, np.pi, np.nextafter(-np.pi, -4)]])
    b = wrap(a)
    assert (b >= -np.pi).all() and (b < np.pi).all()
    assert np.allclose(np.cos(a), np.cos(b)) and np.allclose(np.sin(a), np.sin(b))

# %% right: by whole turns
def catches_bad_wrap(wrap):
    for angle in (0.0, 3.0, -3.0, 4.0, 10.0, -10.0, 100.0, np.pi, -np.pi, np.nextafter(-np.pi, -4)):
        wrapped = float(wrap(angle))
        turns = (angle - wrapped) / (2 * np.pi)
        assert abs(turns - round(turns)) < 1e-9, angle
        assert not wrapped >= np.pi and not wrapped < -np.pi, angle
