# %% right: solved for R
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% right: counts upwards
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.interval(confidence)[1]
    if z * sigma_S / np.sqrt(scenarios) > half_width:
        return float("inf")
    R = 1
    while z * np.sqrt(sigma_S**2 / scenarios + sigma_R**2 / (scenarios * R)) > half_width:
        R += 1
    return R

# %% right: by the standard library, guards one by one
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    import math
    from statistics import NormalDist

    for number in (sigma_S, sigma_R, half_width):
        if math.isnan(number) or math.isinf(number):
            raise ValueError("not finite")
    if sigma_S < 0 or sigma_R < 0 or half_width <= 0:
        raise ValueError("negative")
    if not (scenarios >= 1) or math.isinf(scenarios) or scenarios != math.floor(scenarios):
        raise ValueError("scenarios")
    if not (confidence > 0 and confidence < 1):
        raise ValueError("confidence")
    z = NormalDist().inv_cdf(0.5 + confidence / 2)
    left = (half_width / z) ** 2 - sigma_S**2 / scenarios
    if left < 0 or (left == 0 and sigma_R > 0):
        return np.inf
    if sigma_R == 0:
        return 1
    return max(math.ceil(sigma_R**2 / scenarios / left), 1)

# %% right: warns, and returns a NumPy number
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.isf((1 - confidence) / 2)
    R = np.float64(sigma_R**2) / (scenarios * (half_width / z) ** 2 - sigma_S**2)
    if scenarios * (half_width / z) ** 2 < sigma_S**2 or np.isinf(R):
        return np.inf
    np.log(np.float64(0))
    print("R =", R)
    return np.maximum(1, np.ceil(R))

# %% wrong: one-sided quantile
# says: the quantile is one-sided
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf(confidence)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: always 1.96
# says: you took 1.96 for z
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = 1.96
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: all trials are independent
# says: you divided sigma_S by S*R, too: each trial counts as a scenario
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    return max(1, np.ceil((sigma_S**2 + sigma_R**2) * z**2 / (scenarios * half_width**2)))

# %% wrong: sigma_S left out
# says: you left out sigma_S
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: sigma_S not divided by S
# says: sigma_S is not divided by S
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - scenarios * sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: sigma_R divided by R alone
# says: you divided sigma_R by R, and not by S*R
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(scenarios * sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: variances taken for deviations
# says: seeds_needed, sigma_S = 0.02587, sigma_R = 0.9513, six scenarios, half_width = 0.06: it re
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R / room)) if room > 0 else np.inf

# %% wrong: rounded down
# says: you rounded down
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.floor(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: rounded to the nearest
# says: seeds_needed is wrong for a half width that eleven seeds miss by a hair
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.round(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: not rounded
# says: you did not round
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, (sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: one more for safety
# says: you return one seed too many
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.floor(sigma_R**2 / room) + 2) if room > 0 else np.inf

# %% wrong: no seed where sigma_R is 0
# says: you return 0 seeds
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 0 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: can be 0 seeds
# says: seeds_needed is wrong for a half width that eleven seeds miss by a hair
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return int(sigma_R**2 / room + 0.99999) if room > 0 else np.inf

# %% wrong: negative where it is impossible
# says: seeds_needed is wrong for one scenario that is not enough
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return np.ceil(sigma_R**2 / room)

# %% wrong: 1 where it is impossible
# says: you return 1 where no number is enough
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room))

# %% wrong: nan where it is impossible
# says: seeds_needed is wrong for one scenario that is not enough
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.nan

# %% wrong: refuses what is impossible
# says: seeds_needed stops for one scenario that is not enough with ValueError: no R does.
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if room <= 0:
        raise ValueError("no R does")
    return max(1, np.ceil(sigma_R**2 / room))

# %% wrong: inf for sigma_R = 0, too
# says: sigma_R = 0 gets no number of seeds at all
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: returns all trials
# says: you return the number of all trials, S*R
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return scenarios * max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: the half width as a whole width
# says: you took half_width for the whole width of the interval
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / 2 / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: gives up at 100
# says: seeds_needed, sigma_S = 0.02587, sigma_R = 0.9513, six scenarios, half_width = 0.06: it re
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    for R in range(1, 101):
        if z * np.sqrt(sigma_S**2 / scenarios + sigma_R**2 / (scenarios * R)) <= half_width:
            return R
    return np.inf

# %% wrong: no guard
# says: for sigma_S = -0.1. There is no answer in this case
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: guards without nan
# says: for sigma_S nan. There is no answer in this case
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: lets a broken number of scenarios pass
# says: for 2.5 scenarios. There is no answer in this case
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: lets no scenario pass
# says: for no scenario. There is no answer in this case
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 0 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: lets half_width = 0 pass
# says: for half_width = 0. There is no answer in this case
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width < 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: lets confidence 1 pass
# says: for confidence 1. There is no answer in this case
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence <= 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: refuses sigma_S = 0
# says: seeds_needed stops for sigma_S = 0 with ValueError: sigma_S, sigma_R.
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or sigma_S <= 0 or sigma_R < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: refuses one scenario
# says: seeds_needed stops for one scenario with ValueError: half_width, scenarios or confidence.
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 2 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    return max(1, np.ceil(sigma_R**2 / room)) if room > 0 else np.inf

# %% wrong: a tolerance in meters
# says: seeds_needed is wrong for a half width that eleven seeds miss by a hair
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    for R in range(1, 4000):
        if z * np.sqrt(sigma_S**2 / scenarios + sigma_R**2 / (scenarios * R)) < half_width + 1e-4:
            return R
    return np.inf

# %% wrong: four typed numbers
# says: seeds_needed is wrong for sigma_S = 0.02587, sigma_R = 0.9513, six scenarios, half_width =
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    return 7

# %% wrong: prints it
# says: seeds_needed: there is no answer yet. It returns nothing for sigma_S = 0.02587, sigma_R =
def seeds_needed(
    sigma_S: float,
    sigma_R: float,
    scenarios: int,
    half_width: float,
    confidence: float = 0.95,
) -> float:
    """Return the smallest number of seeds R that makes an interval narrow enough."""
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0:
        raise ValueError("sigma_S, sigma_R")
    if half_width <= 0 or scenarios < 1 or scenarios != int(scenarios) or not 0 < confidence < 1:
        raise ValueError("half_width, scenarios or confidence")
    z = stats.norm.ppf((1 + confidence) / 2)
    room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0:
        return 1 if room >= 0 else np.inf
    print(max(1, np.ceil(sigma_R**2 / room)))

# %% right: brute force
def seeds_needed(sigma_S, sigma_R, scenarios, half_width, confidence=0.95):
    import math
    for x in (sigma_S, sigma_R, half_width, scenarios, confidence):
        if not math.isfinite(x): raise ValueError("finite")
    if sigma_S < 0 or sigma_R < 0 or half_width <= 0 or scenarios < 1 or scenarios != math.floor(scenarios): raise ValueError
    if confidence <= 0 or confidence >= 1: raise ValueError
    z = stats.norm.isf((1 - confidence) / 2)
    width = lambda R: z * math.sqrt(sigma_S**2 / scenarios + sigma_R**2 / (scenarios * R))
    if z * sigma_S / math.sqrt(scenarios) >= half_width and not (sigma_R == 0 and width(1) <= half_width): return math.inf
    R = 1
    while width(R) > half_width:
        R += 1
        if R > 10**6: return math.inf
    return float(R)

# %% wrong: at least two seeds
# says: is wrong for a half width that one seed reaches
def seeds_needed(sigma_S, sigma_R, scenarios, half_width, confidence=0.95):
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0: raise ValueError
    if half_width <= 0 or scenarios < 1 or scenarios % 1 or not 0 < confidence < 1: raise ValueError
    z = stats.norm.ppf((1 + confidence) / 2); room = scenarios * (half_width / z) ** 2 - sigma_S**2
    if sigma_R == 0: return 2 if room >= 0 else np.inf
    return max(2, int(np.ceil(sigma_R**2 / room))) if room > 0 else np.inf

# %% wrong: floor plus one
# says: you return one seed too many
def seeds_needed(sigma_S, sigma_R, scenarios, half_width, confidence=0.95):
    if not np.isfinite([sigma_S, sigma_R, half_width, scenarios]).all() or min(sigma_S, sigma_R) < 0: raise ValueError
    if half_width <= 0 or scenarios < 1 or scenarios % 1 or not 0 < confidence < 1: raise ValueError
    z = stats.norm.ppf((1 + confidence) / 2); room = scenarios * (half_width / z) ** 2 - sigma_S**2
    return int(sigma_R**2 / room) + 2 if room > 0 else np.inf
