# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause

"""Motion models of underwater vehicles from their logs: docs/python.md.

SI units; surge, sway, heave in m/s and N, roll, pitch, yaw in rad/s and N m. Functions take a Log, a
path, or a list of either. What cannot be used raises ValueError with the sentence of the tool. A red
finding is a FindingWarning.
"""

from fathom._fathom import (
    Cause,
    Checkup,
    Comparison,
    ComparisonRow,
    CoupledDiagnosis,
    CoupledIdentification,
    CoupledModel,
    CoupledPrediction,
    CoupledRefinement,
    Decay,
    Diagnosis,
    Figures,
    Finding,
    FindingWarning,
    Identification,
    Log,
    Model,
    Parameter,
    Prediction,
    Refinement,
    Track,
    Trajectory,
    __version__,
    check,
    compare,
    free_decay,
    open_log,
    read_model,
    track,
)
from fathom import _fathom

__all__ = [
    "Cause",
    "Checkup",
    "Comparison",
    "ComparisonRow",
    "CoupledDiagnosis",
    "CoupledIdentification",
    "CoupledModel",
    "CoupledPrediction",
    "CoupledRefinement",
    "Decay",
    "Diagnosis",
    "Figures",
    "Finding",
    "FindingWarning",
    "Identification",
    "Log",
    "Model",
    "Parameter",
    "Prediction",
    "Refinement",
    "Track",
    "Trajectory",
    "__version__",
    "check",
    "compare",
    "diagnose",
    "free_decay",
    "identify",
    "open_log",
    "read_model",
    "refine",
    "simulate",
    "track",
]


def _with_defaults(given, defaults, why):
    """The options that were given, over their defaults; those that are not known here are refused."""
    for name, value in given.items():
        if value is not None and name not in defaults:
            raise ValueError(f"{name}: {why}")
    return {
        name: default if given[name] is None else given[name]
        for name, default in defaults.items()
    }


_OF_ONE = "goes with a model of one DOF, expected none beside dofs."
_OF_SEVERAL = "goes with dofs, expected none: without it a model of one DOF is made."


def identify(
    log,
    *,
    dof=None,
    family=None,
    source=None,
    offset=None,
    gains=None,
    integrator=None,
    huber=None,
    shooting_window=None,
    weighting=None,
    dofs=None,
    structure=None,
    free=None,
    window=None,
):
    """The model of one DOF, or with dofs of several coupled ones, from one log or several.

    log              a Log, a path, or a list of either, which are fitted together
    dof              default: the only one that the log names
    family           "output_error" (default), "least_squares", "adaptive", "joint"
    source           "pose_estimator" (velocities) or "camera" (poses); default: the better one
    offset           of several logs: "shared" (default) or "per_log" buoyancy
    gains            of the adaptive law: a_m [1/s], l1, l2, l3, l4; default: chosen from the data
    integrator       of the adaptive law: "runge_kutta" (default) or "euler"
    huber            residuals beyond so many standard deviations count linearly; 0: never. Default 3
    shooting_window  longer segments are cut [s]; 0: never. Default 600
    weighting        "plain" (default) or "learned"
    dofs             several, as ["surge", "sway", "yaw"]: docs/coupled.md
    structure        of dofs: "auto" (default), "diagonal", "coriolis", "lift", "symmetric", "full",
                     "lopsided"
    free             of dofs: numbers that are free beside a structure, as ["inertia.sway.yaw"]
    window           of dofs: the simulation begins anew after so long [s]. Default 20

    An Identification, or with dofs a CoupledIdentification. A fit that does not work does not raise:
    is_usable and message say so.
    """
    given = {name: value for name, value in locals().items() if name != "log"}
    if dofs is not None:
        defaults = {"dofs": dofs, "structure": "auto", "free": [], "window": 20.0}
        return _fathom.identify_coupled(
            log, **_with_defaults(given, defaults, _OF_ONE)
        )
    defaults = {
        "dof": None,
        "family": "output_error",
        "source": None,
        "offset": "shared",
        "gains": None,
        "integrator": "runge_kutta",
        "huber": 3.0,
        "shooting_window": 600.0,
        "weighting": "plain",
    }
    return _fathom.identify_one(log, **_with_defaults(given, defaults, _OF_SEVERAL))


def diagnose(
    log,
    *,
    dof=None,
    source=None,
    false_alarm_rate=None,
    effort=None,
    seed=None,
    dofs=None,
    window=None,
):
    """What a model gets wrong, and why: docs/diagnosis.md, with dofs docs/coupled.md.

    log               a Log, a path, or a list of either, which are diagnosed together
    dof               default: the only one that the log names
    source            "pose_estimator" or "camera"; default: all that the logs have
    false_alarm_rate  of naming a cause where nothing is missing. Default 0.05
    effort            how long causes are searched, as a multiple of the usual. Default 1
    seed              of the random draws behind the thresholds. Default 1
    dofs              several, as ["surge", "sway", "yaw"]: couplings and weak thrusters
    window            of dofs: the simulation begins anew after so long [s]. Default 20

    A Diagnosis, or with dofs a CoupledDiagnosis. Raises ValueError where there is none.
    """
    given = {name: value for name, value in locals().items() if name != "log"}
    if dofs is not None:
        defaults = {"dofs": dofs, "window": 20.0}
        return _fathom.diagnose_coupled(
            log, **_with_defaults(given, defaults, _OF_ONE)
        )
    defaults = {
        "dof": None,
        "source": None,
        "false_alarm_rate": 0.05,
        "effort": 1.0,
        "seed": 1,
    }
    return _fathom.diagnose_one(log, **_with_defaults(given, defaults, _OF_SEVERAL))


def refine(
    log,
    *,
    dof=None,
    initial_guess=None,
    clock_offset_std=None,
    size_scale_std=None,
    mount_position_std=None,
    mount_angle_std=None,
    gains=None,
    integrator=None,
    huber=None,
    shooting_window=None,
    weighting=None,
    dofs=None,
    structure=None,
    free=None,
    window=None,
    true_poses=None,
):
    """Model and camera path together, from the corners of markers: docs/joint_refinement.md.

    log                 a Log with detections, a path, or a list of either, refined together
    dof                 default: the only one that the log names
    initial_guess       "least_squares", "adaptive", "output_error"; default: output error on poses
                        without flips
    clock_offset_std    estimate the camera's clock offset, with this prior deviation [s]. Default 0: exact
    size_scale_std      the same of the markers' scale [-]
    mount_position_std  the same of the camera's position on the vehicle [m]
    mount_angle_std     the same of the camera's direction [rad]
    gains, integrator, huber, shooting_window, weighting
                        of the families beside it, as identify() has them
    dofs                several, as ["surge", "sway", "yaw"]: docs/coupled.md
    structure           of dofs: "auto" (default), "diagonal", "coriolis", "lift", "symmetric", "full",
                        "lopsided"
    free                of dofs: numbers that are free beside a structure, as ["inertia.sway.yaw"]
    window              of dofs: the simulation begins anew after so long [s]. Default 20
    true_poses          of dofs: the path of a CSV as pose.csv, for path_errors

    A Refinement, or with dofs a CoupledRefinement. A fit that does not work does not raise:
    is_usable and message say so.
    """
    given = {name: value for name, value in locals().items() if name != "log"}
    if dofs is not None:
        defaults = {
            "dofs": dofs,
            "structure": "auto",
            "free": [],
            "window": 20.0,
            "true_poses": None,
        }
        return _fathom.refine_coupled(log, **_with_defaults(given, defaults, _OF_ONE))
    defaults = {
        "dof": None,
        "initial_guess": None,
        "clock_offset_std": 0.0,
        "size_scale_std": 0.0,
        "mount_position_std": 0.0,
        "mount_angle_std": 0.0,
        "gains": None,
        "integrator": "runge_kutta",
        "huber": 3.0,
        "shooting_window": 600.0,
        "weighting": "plain",
    }
    return _fathom.refine_one(log, **_with_defaults(given, defaults, _OF_SEVERAL))


def simulate(model, log, *, keep_run_effects=False, horizon=None):
    """What a model predicts for a log from its command alone, scored against its measurement.

    model             a Model, a CoupledModel, what identify(), refine() or diagnose() returns, or the
                      path of a model or verdict file
    log               a Log, or a path
    keep_run_effects  keep effects of a run (a current, a bias) also on other logs
    horizon           of a CoupledModel: begin anew from the measured state after so long [s]

    A Prediction of a Model, a CoupledPrediction of a CoupledModel.
    """
    if not isinstance(model, (Model, CoupledModel)):
        model = model.model if hasattr(model, "model") else read_model(model)
    if isinstance(model, Model):
        if horizon is not None:
            raise ValueError(
                "horizon: goes with a model of several DOFs, expected none: this one is of one."
            )
        return _fathom.simulate_one(model, log, keep_run_effects)
    if keep_run_effects:
        raise ValueError(
            "keep_run_effects: a model of several DOFs has no effects, expected none."
        )
    return _fathom.simulate_coupled(
        model, log, float("inf") if horizon is None else horizon
    )
