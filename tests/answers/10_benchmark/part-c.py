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
