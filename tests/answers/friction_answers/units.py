"""Units of the quantities."""

UNITS = {
    "along_m": "m",
    "left_m": "m",
    "lower_m": "m",
    "upper_m": "m",
    "distance_m": "m",
    "sink_m": "m",
    "drift_m": "m",
    "turn_rad": "rad",
    "stop_s": "s",
    "slide_m": "m",
    "slide_s": "s",
    "creep_m_s": "m/s",
    "rolling_speed_m_s": "m/s",
    "along_m_s": "m/s",
    "left_m_s": "m/s",
    "other_along_m_s": "m/s",
    "other_left_m_s": "m/s",
    "spin_rad_s": "rad/s",
    "other_spin_rad_s": "rad/s",
}
