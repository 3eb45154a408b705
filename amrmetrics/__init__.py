"""Metrics for localization and SLAM of mobile robots.

Use it as ``import amrmetrics as am``. Reference (ground truth) comes before
estimate in every function. A trajectory is an array of homogeneous matrices of
shape ``(N, d + 1, d + 1)`` with d = 2 or 3; lengths are in metres, times in
seconds, angles in radians unless a name says degrees. Bad input raises
:class:`amrmetrics.errors.AmrError`, a ``ValueError`` that names the argument.

Importing the package loads NumPy only; each module loads when it is first used.
"""

import lazy_loader as _lazy

__version__ = "0.1.0"

__getattr__, __dir__, __all__ = _lazy.attach(
    __name__,
    submodules=["check", "comparison", "derivation", "plotting", "simulation"],
    submod_attrs={
        "aggregation": ["Aggregate", "aggregate"],
        "alignment": ["Alignment", "align"],
        "comparison": ["Comparison", "compare_paired", "holm"],
        "consistency": [
            "ConsistencyTest",
            "consistency_power",
            "consistency_test",
            "expected_nees",
            "nees",
            "nees_variance",
            "nis",
            "pose_errors",
            "runs_needed",
        ],
        "errors": ["AmrError", "DegenerateAlignmentError", "RecordingWarning"],
        "files": [
            "Trajectory",
            "read_euroc",
            "read_kitti",
            "read_tum",
            "write_kitti",
            "write_tum",
        ],
        "g2o": ["read_g2o", "write_g2o"],
        "least_squares": ["Optimization", "optimize"],
        "loops": [
            "InlierRatio",
            "PrecisionRecall",
            "ResidualSummary",
            "inlier_ratio",
            "precision_recall",
            "residual_summary",
        ],
        "maps": [
            "Confusion",
            "MapDistance",
            "ThresholdSweep",
            "chamfer",
            "confusion",
            "hausdorff",
            "threshold_sweep",
        ],
        "pose_graph": ["PoseGraph"],
        "poses": [
            "inverse",
            "path_length",
            "planar_poses",
            "positions",
            "project",
            "relative",
            "rotation_angle",
            "spatial_poses",
            "wrap",
            "yaw",
        ],
        "resampling": ["compare_bootstrap", "compare_sign_flip"],
        "resources": [
            "Energy",
            "Measurement",
            "ResourceUse",
            "energy",
            "measure",
            "resource_use",
        ],
        "runtime": [
            "Latency",
            "Percentile",
            "RelocalizationTime",
            "frames_needed",
            "latency",
            "percentile",
            "relocalization_time",
        ],
        "scoring": ["Murphy", "Score", "brier", "cross_entropy", "murphy"],
        "stamps": ["associate", "clock_offset", "interpolate"],
        "trajectory": [
            "DriftRate",
            "ErrorSummary",
            "RelativeError",
            "SegmentDrift",
            "ate",
            "drift_rate",
            "pool",
            "rpe",
            "segment_drift",
        ],
    },
)
