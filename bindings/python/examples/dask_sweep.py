"""A sweep on Dask: on this machine, or on the cluster of the client that there is."""

import dask
import tribos


def rows(scene, keys, seeds=1):
    """One row a run, in the order of the combinations."""
    case = dask.delayed(tribos.run_case)
    text = scene.to_toml()
    jobs = tribos.cases(scene, keys, seeds=seeds)
    return list(dask.compute(*[case(text, job) for job in jobs]))


if __name__ == "__main__":
    for row in rows(tribos.scene("disk"), {"spin": [0.0, 5.0, 50.0]}):
        print(row["spin"], "rad/s:", row["distance"], "m")
