"""Lower bounds of the time of each case on this machine, in seconds; see docs/performance.md."""

FLOAT = 4  # bytes


def at_peak(flops, machine):
    return flops / machine["flops"]


def inner_products(case, machine):
    """Few samples: their products with each other and with the map at the start and the end, and
    neurons x samples double-precision multiply-adds a step; and the map written once."""
    n, s, d, t = case["neurons"], case["samples"], case["features"], case["steps"]
    if case["sparse"]:
        d = max(1, d // 100)
    flops = 2 * (s * s * d + 2 * n * s * d) + 2 * n * s * t
    return 2 * at_peak(flops, machine) + FLOAT * n * case["stored"] / machine["write"]


def streaming(case, machine):
    """Each weight of an element that a sample has: distance and update, 6 operations, or read and
    written in memory, whichever takes longer where the map is larger than the caches."""
    elements = case["features"] // 100 if case["sparse"] else case["features"]
    weights = case["neurons"] * max(1, elements) * case["steps"]
    if case["sparse"]:
        return 2 * FLOAT * weights / machine["change"]
    return at_peak(6 * weights, machine)


def sparse_batch(case, machine):
    """The map read and written once an epoch, as far as any sample reaches."""
    return 2 * FLOAT * case["neurons"] * case["stored"] * case["steps"] / machine["change"]


def product(case, _):
    """The bare product of samples and weights, as BLAS does it in the same run."""
    if "product_seconds" not in case:
        return None
    return case["product_seconds"] * max(1, case["counted_steps"])


def t_mpsom(case, machine):
    """All weights read and written once a frame."""
    return 2 * FLOAT * case["weights"] * case["steps"] / machine["change"]


RULES = {
    "dense_batch": product,
    "hexagonal_batch": product,
    "few_samples": inner_products,
    "few_samples_streaming": streaming,
    "sparse_uniform_start": inner_products,
    "sparse_sample_start": inner_products,
    "sparse_batch": sparse_batch,
    "sparse_streaming": streaming,
    "winners": product,
    "clustered_search": product,
    "t_mpsom": t_mpsom,
    "t_mpsom_large": t_mpsom,
    "large_file": product,
}


def limit(name, case, machine):
    """Seconds, or None where there is no rule or nothing to go by. `machine`: limits.cc's figures."""
    rule = RULES.get(name)
    return rule(case, machine) if rule else None
