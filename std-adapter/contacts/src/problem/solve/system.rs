//! The linear systems of Newton's methods: B Δr + C W Δr = right, with a square of B and of C at each contact.

use super::blocks::Blocks;
use super::bodies::BodyFactorisation;
use super::cone::Square;
use super::factor::Lu;
use super::prepared::Prepared;

/// B and C of one contact.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Linear {
    pub impulse: Square,
    /// C; none for the identity.
    pub velocity: Option<Square>,
}

/// Measured time of a step for each contact, apart from the factorisation, in multiplications.
const A_CONTACT: f64 = 2500.0;
/// Corrections of a solution with the matrix itself.
const REFINEMENTS: usize = 2;
/// Square of a residual, over that of the right-hand side, below which no correction is due.
const ROUNDING: f64 = 1e-26;

/// The system, factorised over contacts or over bodies.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// B + C W.
    matrix: Blocks,
    factors: Factors,
    pub factorisations: usize,
}

#[derive(Clone, Debug)]
enum Factors {
    Contacts(Lu),
    Bodies(Box<BodyFactorisation>),
}

impl System {
    /// Prepares the way with fewer multiplications.
    pub fn new(problem: &Prepared) -> Self {
        let contacts = Lu::new(&problem.w);
        let bodies = problem.bodies.as_ref().map(BodyFactorisation::new);
        let factors = match bodies {
            Some(bodies) if bodies.cost() < contacts.cost() => Factors::Bodies(Box::new(bodies)),
            _ => Factors::Contacts(contacts),
        };
        Self {
            matrix: problem.w.clone(),
            factors,
            factorisations: 0,
        }
    }

    /// Time of a step with a factorisation, in multiplications.
    pub fn cost(&self, problem: &Prepared) -> f64 {
        let factors = match &self.factors {
            Factors::Contacts(lu) => lu.cost(),
            Factors::Bodies(bodies) => bodies.cost(),
        };
        factors + A_CONTACT * problem.contacts() as f64
    }

    /// Time of a step that costs no factorisation.
    pub fn least_cost(problem: &Prepared) -> f64 {
        A_CONTACT * problem.contacts() as f64
    }

    /// Factorises for these squares.
    pub fn factorise(&mut self, problem: &Prepared, linear: &[Linear]) {
        self.matrix.values.copy_from_slice(&problem.w.values);
        for (contact, own) in linear.iter().enumerate() {
            let rows = problem.w.size(contact);
            let Some(velocity) = &own.velocity else {
                self.add(contact, rows, &own.impulse);
                continue;
            };
            for number in problem.w.row(contact) {
                let column = problem.w.columns[number];
                let width = problem.w.size(column);
                let from = problem.w.block(number);
                let to = self.matrix.block_mut(number);
                for row in 0..rows {
                    for at in 0..width {
                        let mut sum = 0.0;
                        for inner in 0..rows {
                            sum += velocity[row][inner] * from[inner * width + at];
                        }
                        to[row * width + at] = sum;
                    }
                }
            }
            self.add(contact, rows, &own.impulse);
        }
        match (&mut self.factors, &problem.bodies) {
            (Factors::Bodies(factors), Some(bodies)) => factors.factorise(bodies, problem, linear),
            (Factors::Contacts(lu), _) => lu.factorise(&self.matrix),
            (Factors::Bodies(_), None) => {}
        }
        self.factorisations += 1;
    }

    /// Adds a square to the diagonal block of a contact.
    fn add(&mut self, contact: usize, size: usize, square: &Square) {
        if let Some(number) = self.matrix.find(contact, contact) {
            for (line, row) in self
                .matrix
                .block_mut(number)
                .chunks_exact_mut(size)
                .zip(square)
            {
                for (entry, value) in line.iter_mut().zip(row) {
                    *entry += value;
                }
            }
        }
    }

    /// Replaces the right-hand side by the solution, corrected while its residual is above rounding.
    pub fn solve(&self, problem: &Prepared, vector: &mut [f64]) {
        let right = vector.to_vec();
        let enough = ROUNDING * size_sq(&right);
        let mut left = vec![0.0; right.len()];
        self.divide(problem, vector);
        for _ in 0..REFINEMENTS {
            self.matrix.multiply(vector, &mut left);
            for (left, right) in left.iter_mut().zip(&right) {
                *left = right - *left;
            }
            if size_sq(&left) <= enough {
                break;
            }
            self.divide(problem, &mut left);
            for (value, change) in vector.iter_mut().zip(&left) {
                *value += change;
            }
        }
    }

    fn divide(&self, problem: &Prepared, vector: &mut [f64]) {
        match (&self.factors, &problem.bodies) {
            (Factors::Bodies(factors), Some(bodies)) => factors.solve(bodies, problem, vector),
            (Factors::Contacts(lu), _) => lu.solve(vector),
            (Factors::Bodies(_), None) => {}
        }
    }
}

fn size_sq(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum()
}
