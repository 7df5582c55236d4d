"""Atoms: forces against finite differences and ASE, motion against closed forms."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest
from tribos import md

RNG = np.random.default_rng(7)


def cluster(count: int = 20) -> np.ndarray:
    """Atoms on a shaken lattice, about 1.1 apart."""
    side = math.ceil(count ** (1 / 3))
    grid = np.stack(np.meshgrid(*[np.arange(side)] * 3), axis=-1).reshape(-1, 3)[:count] * 1.12
    return grid + RNG.uniform(-0.05, 0.05, grid.shape)


@pytest.mark.parametrize("shift", ["none", "energy", "force"])
def test_forces_are_the_gradient_of_the_energy(shift: str) -> None:
    places = cluster()
    potential = md.LennardJones(
        [1.0, 0.7],
        [1.0, 0.9],
        [2.5, 2.3],
        shift=shift,
        mixing="arithmetic",  # type: ignore[arg-type]
    )
    kinds = [at % 2 for at in range(len(places))]
    made = potential.evaluate(places, species=kinds)
    assert np.abs(made.forces.sum(axis=0)).max() < 1e-10 * np.abs(made.forces).max()
    h = 1e-6
    for atom in (0, 7, 19):
        for axis in range(3):
            ends = []
            for sign in (1, -1):
                moved = places.copy()
                moved[atom, axis] += sign * h
                ends.append(potential.evaluate(moved, species=kinds).energy)
            slope = (ends[0] - ends[1]) / (2 * h)
            # With a jump at the cut-off no pair of these crosses it.
            assert -slope == pytest.approx(made.forces[atom, axis], rel=1e-6, abs=1e-6)


def test_the_energy_is_the_sum_over_pairs() -> None:
    places = cluster(12)
    apart = np.linalg.norm(places[:, None] - places[None], axis=-1)[np.triu_indices(12, 1)]
    near = apart[apart < 2.0]
    expected = (4 * 0.3 * ((0.9 / near) ** 12 - (0.9 / near) ** 6)).sum()
    made = md.LennardJones(0.3, 0.9, 2.0).evaluate(places)
    assert made.energy == pytest.approx(expected, rel=1e-13)


def test_a_pair_vibrates_with_the_period_of_the_closed_form() -> None:
    bond = 2 ** (1 / 6)
    period = 2 * math.pi * bond / 12
    system = md.System([[0, 0, 0], [bond + 1e-4, 0, 0]], md.LennardJones(), time_step=period / 1000)
    system.step(500)
    stretch = system.positions[1, 0] - system.positions[0, 0] - bond
    assert stretch == pytest.approx(-1e-4, rel=2e-3)
    assert system.time == pytest.approx(period / 2) and system.steps == 500
    assert system.potential_energy == pytest.approx(-1.0, abs=1e-4)


@pytest.mark.parametrize("thermostat", [None, md.NoseHoover(0.3), md.Langevin(0.3)])
@pytest.mark.parametrize("integrator", ["velocity-verlet", "leap-frog"])
def test_a_pickled_system_goes_on_to_the_same_bits(thermostat: object, integrator: str) -> None:
    places = cluster(64)
    system = md.System(
        places,
        md.LennardJones(shift="force"),
        velocities=RNG.normal(0.0, 0.5, places.shape),
        period=(None, 6.0, 6.0),
        thermostat=thermostat,  # type: ignore[arg-type]
        integrator=integrator,  # type: ignore[arg-type]
    )
    before = system.conserved_energy
    system.step(30)
    again = pickle.loads(pickle.dumps(system))
    system.step(40)
    again.step(25)
    again.step(15)
    for name in ("positions", "velocities", "forces"):
        assert np.array_equal(getattr(system, name), getattr(again, name)), name
    assert again.steps == 70
    if not isinstance(thermostat, md.Langevin):
        assert system.conserved_energy == pytest.approx(before, rel=1e-4)
    kinetic = 0.5 * (system.velocities**2).sum()
    assert system.kinetic_energy == pytest.approx(kinetic, rel=1e-12)
    freedoms = 3 * 64 if isinstance(thermostat, md.Langevin) else 3 * 63
    assert system.temperature == pytest.approx(2 * kinetic / freedoms, rel=1e-12)


def test_what_cannot_be_is_refused_with_the_librarys_words() -> None:
    with pytest.raises(ValueError, match="epsilon11 must be finite and positive"):
        md.LennardJones(-1.0)
    with pytest.raises(ValueError, match="exceeds half the period along x"):
        md.LennardJones().evaluate([[0, 0, 0]], period=(4.0, None, None))
    with pytest.raises(ValueError, match="shift must be one of none, energy, force"):
        md.LennardJones(shift="both")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="temperature of a thermostat"):
        md.System([[0, 0, 0]], md.LennardJones(), thermostat=md.Langevin(-1.0))
    with pytest.raises(ValueError, match="shape"):
        md.System([[0, 0]], md.LennardJones())
    fast = md.System([[0, 0, 0]], md.LennardJones(), velocities=[[1e6, 0, 0]])
    with pytest.raises(RuntimeError):
        fast.step()


def test_the_calculator_agrees_with_ases_own_for_a_free_cluster() -> None:
    ase = pytest.importorskip("ase")
    from ase.calculators.lj import LennardJones
    from tribos.ase import Calculator

    atoms = ase.Atoms("Ar20", positions=3.4 * cluster())
    atoms.calc = LennardJones(epsilon=0.0104, sigma=3.4, rc=8.5)
    energy, forces = atoms.get_potential_energy(), atoms.get_forces()
    atoms.calc = Calculator(epsilon=0.0104, sigma=3.4, cutoff=8.5)
    assert atoms.get_potential_energy() == pytest.approx(energy, rel=1e-12)
    assert np.allclose(atoms.get_forces(), forces, rtol=1e-11, atol=1e-13)
    # Symbols with the same parameters are the same atoms.
    atoms.symbols[:5] = "Kr"
    both = {"Ar": 0.0104, "Kr": 0.0104}
    atoms.calc = Calculator(epsilon=both, sigma=3.4, cutoff=8.5)
    assert atoms.get_potential_energy() == pytest.approx(energy, rel=1e-12)
    with pytest.raises(ValueError, match="no parameters for Kr"):
        atoms.calc = Calculator(epsilon={"Ar": 0.0104}, sigma=3.4, cutoff=8.5)
        atoms.get_potential_energy()


def test_the_stress_is_the_strains_derivative_of_the_energy() -> None:
    ase = pytest.importorskip("ase")
    from ase.calculators.lj import LennardJones
    from tribos.ase import Calculator

    sides = np.array([12.0, 13.0, 14.0])
    places = RNG.permutation(np.stack(np.meshgrid(*[np.arange(3)] * 3), -1).reshape(-1, 3))
    atoms = ase.Atoms("Ar27", positions=(places + 0.1 * RNG.random((27, 3))) * sides / 3)
    atoms.set_cell(sides)
    atoms.pbc = True
    atoms.calc = Calculator(epsilon=0.0104, sigma=3.4, cutoff=5.9, shift="force")
    stress = atoms.get_stress()
    h = 1e-6
    for axis in range(3):
        ends = []
        for sign in (1, -1):
            strained = atoms.copy()
            factors = np.ones(3)
            factors[axis] += sign * h
            strained.set_cell(sides * factors, scale_atoms=True)
            strained.calc = atoms.calc
            ends.append(strained.get_potential_energy())
        slope = (ends[0] - ends[1]) / (2 * h) / sides.prod()
        assert stress[axis] == pytest.approx(slope, rel=1e-6)
    # All six components as ASE's own, whose cut-off is smooth in no way: the same energy shift.
    atoms.calc = Calculator(epsilon=0.0104, sigma=3.4, cutoff=6.0)
    mine = atoms.get_stress()
    atoms.calc = LennardJones(epsilon=0.0104, sigma=3.4, rc=6.0)
    assert np.allclose(mine, atoms.get_stress(), rtol=1e-9, atol=1e-14)
    # A cell that is smaller than the cut-off, open along z.
    small = ase.Atoms("Ar2", positions=[[0.1, 0, 0], [2.0, 2.1, 1.7]], cell=[4.1, 4.0, 20.0])
    small.pbc = (True, True, False)
    made = []
    for calculator in (LennardJones, Calculator):
        reach = {"rc": 8.5} if calculator is LennardJones else {"cutoff": 8.5}
        small.calc = calculator(epsilon=0.0104, sigma=3.4, **reach)
        made.append((small.get_potential_energy(), small.get_forces(), small.get_stress()))
    for one, other in zip(*made):
        assert np.allclose(one, other, rtol=1e-10, atol=1e-13)
    atoms.set_cell([[12, 1, 0], [0, 13, 0], [0, 0, 14]])
    atoms.calc = Calculator(epsilon=0.0104, sigma=3.4, cutoff=6.0)
    with pytest.raises(ValueError, match="right angles"):
        atoms.get_potential_energy()


def test_the_calculator_serves_ases_optimiser() -> None:
    ase = pytest.importorskip("ase")
    from ase.optimize import BFGS
    from tribos.ase import Calculator

    pair = ase.Atoms("Ar2", positions=[[0, 0, 0], [4.2, 0, 0]])
    pair.calc = Calculator(epsilon=0.0104, sigma=3.4, cutoff=40.0, shift="none")
    BFGS(pair, logfile=None).run(fmax=1e-8, steps=200)
    assert pair.get_distance(0, 1) == pytest.approx(3.4 * 2 ** (1 / 6), rel=1e-6)
    assert pair.get_potential_energy() == pytest.approx(-0.0104, rel=1e-9)
