#!/usr/bin/env python3
"""sensitivity.py STUDY.csv FEATURE [FIGURE.png] - which keys of a sampled study decide a feature.

Prints Sobol's first-order and total index of each key with bounds of 90 %, and draws the tornado figure: the feature
where one key is at its limits and the others are in the middle. For tables of squat study --sample or --points whose
points fill a box evenly. The indices are those of a polynomial chaos through the points (OpenTURNS; sparse, least angle
regression); the bounds are those of 100 fits to points drawn again (bootstrap). Needs python3-openturns, and
python3-matplotlib for the figure."""

import csv
import sys

import openturns

FITS, DEGREE = 100, 8


def read(path, feature):
    """Keys, points and values; runs that failed and those without the feature are left out."""
    with open(path, newline="") as file:
        names, *rows = list(csv.reader(file))
    keys = names[: names.index("state")]
    named = [name for name in names if name == feature or name.split(" [")[0].replace(" ", "_") == feature]
    if not named:
        sys.exit(f"{path}: no feature {feature}; one of " + ", ".join(names[len(keys) + 1 : -1]))
    column = names.index(named[0])
    rows = [row for row in rows if row[len(keys)] == "done" and row[column]]
    points = [[float(value) for value in row[: len(keys)]] for row in rows]
    return keys, points, [[float(row[column])] for row in rows], named[0]


def fit(points, values, inputs):
    keys = inputs.getDimension()
    terms = openturns.HyperbolicAnisotropicEnumerateFunction(keys, 0.7)
    basis = openturns.OrthogonalProductPolynomialFactory([openturns.LegendreFactory()] * keys, terms)
    size = min(terms.getBasisSizeFromTotalDegree(DEGREE), 2 * len(points) // 3)
    selection = openturns.LeastSquaresMetaModelSelectionFactory(openturns.LARS(), openturns.CorrectedLeaveOneOut())
    algorithm = openturns.FunctionalChaosAlgorithm(
        openturns.Sample(points),
        openturns.Sample(values),
        inputs,
        openturns.FixedStrategy(basis, size),
        openturns.LeastSquaresStrategy(selection),
    )
    algorithm.run()
    return algorithm.getResult()


def indices(result, dimension):
    sobol = openturns.FunctionalChaosSobolIndices(result)
    return [sobol.getSobolIndex(i) for i in range(dimension)] + [sobol.getSobolTotalIndex(i) for i in range(dimension)]


def bounds(points, values, inputs):
    """5 % and 95 % of each index over fits to points that were drawn again."""
    fits = openturns.Sample(0, 2 * inputs.getDimension())
    for _ in range(FITS):
        # A point that is drawn twice has no leave-one-out error: each is taken once.
        chosen = sorted({int(openturns.RandomGenerator.IntegerGenerate(len(points))) for _ in points})
        fits.add(indices(fit([points[i] for i in chosen], [values[i] for i in chosen], inputs), inputs.getDimension()))
    return fits.computeQuantilePerComponent(0.05), fits.computeQuantilePerComponent(0.95)


def swings(model, inputs):
    """The feature at the lower and upper limit of each key, the others in the middle."""
    low, high = inputs.getRange().getLowerBound(), inputs.getRange().getUpperBound()
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    at = lambda i, value: model(middle[:i] + [value] + middle[i + 1 :])[0]
    return model(middle)[0], [(at(i, low[i]), at(i, high[i])) for i in range(len(middle))]


def draw(path, keys, middle, pairs, feature):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    order = sorted(range(len(keys)), key=lambda i: abs(pairs[i][1] - pairs[i][0]))
    figure, axes = pyplot.subplots(figsize=(6, 1 + 0.4 * len(keys)), layout="constrained")
    for row, i in enumerate(order):
        for value, colour in zip(pairs[i], ("#4477aa", "#cc6677")):
            axes.barh(row, value - middle, left=middle, fc=colour)
    axes.set_yticks(range(len(keys)), [keys[i] for i in order])
    axes.axvline(middle, c="black", linewidth=0.8)
    axes.set_xlabel(f"{feature}; blue: key at its lower limit, red: upper")
    figure.savefig(path, dpi=200)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    keys, points, values, feature = read(sys.argv[1], sys.argv[2])
    if len(points) < 10 * len(keys):
        sys.exit(f"{sys.argv[1]}: {len(points)} runs; at least 10 for each of the {len(keys)} keys")
    openturns.RandomGenerator.SetSeed(1)
    inputs = openturns.ComposedDistribution([openturns.Uniform(min(column), max(column)) for column in zip(*points)])
    result = fit(points, values, inputs)
    found, (low, high) = indices(result, len(keys)), bounds(points, values, inputs)
    print(f"{feature}, {len(points)} runs")
    print(f"{'key':30} {'first order':>24} {'total':>24}")
    for i, key in enumerate(keys):
        cells = [f"{found[j]:8.3f} ({low[j]:.3f} to {high[j]:.3f})" for j in (i, i + len(keys))]
        print(f"{key:30} {cells[0]:>24} {cells[1]:>24}")
    if len(sys.argv) == 4:
        draw(sys.argv[3], keys, *swings(result.getMetaModel(), inputs), feature)


if __name__ == "__main__":
    main()
