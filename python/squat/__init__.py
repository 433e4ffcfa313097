"""Axle box acceleration at defects of a rail: the solver of Squat Studio as a module.

    case = squat.load_case("light-defect", mesh="tiny")
    case["defect.depth"] = 0.15                  # in the unit of the case file: mm
    result = squat.run(case)
    print(result.features["peak"], result["aba_filtered"])

Cases: load_case, parse_case, shipped_cases, parameters. Runs: run, read_result. Records: detect, estimate. Tracks:
receptance, decay_rates. Results are in SI units, and arrays show the library's memory without a copy. Errors: CaseError,
RunError, FileError. Messages of computations go to the logger "squat".
"""

from ._solver import (
    Case,
    CaseError,
    DecayRates,
    Detection,
    Error,
    Estimate,
    Event,
    FileError,
    Receptance,
    Result,
    RunError,
    __version__,
    decay_rates,
    detect,
    estimate,
    load_case,
    parameters,
    parse_case,
    read_result,
    receptance,
    run,
    shipped_cases,
)

__all__ = [
    "Case",
    "CaseError",
    "DecayRates",
    "Detection",
    "Error",
    "Estimate",
    "Event",
    "FileError",
    "Receptance",
    "Result",
    "RunError",
    "__version__",
    "decay_rates",
    "detect",
    "estimate",
    "load_case",
    "parameters",
    "parse_case",
    "read_result",
    "receptance",
    "run",
    "shipped_cases",
]
