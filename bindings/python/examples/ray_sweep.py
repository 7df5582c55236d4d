"""A sweep on Ray: on this machine, or on the cluster that ``ray.init`` finds."""

import ray
import tribos


def rows(scene, keys, seeds=1):
    """One row a run, in the order of the combinations."""
    ray.init(ignore_reinit_error=True)
    case = ray.remote(tribos.run_case)
    text = scene.to_toml()
    jobs = tribos.cases(scene, keys, seeds=seeds)
    return ray.get([case.remote(text, job) for job in jobs])


if __name__ == "__main__":
    for row in rows(tribos.scene("disk"), {"spin": [0.0, 5.0, 50.0]}):
        print(row["spin"], "rad/s:", row["distance"], "m")
