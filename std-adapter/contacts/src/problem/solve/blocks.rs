//! Square matrices of small dense blocks: rows and columns belong to nodes of a few unknowns each.

/// A matrix of dense blocks between nodes, stored by rows of blocks, each block by rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Blocks {
    /// First unknown of each node, and the number of unknowns.
    pub first: Vec<usize>,
    /// First block of each row of blocks, and the number of blocks.
    pub starts: Vec<usize>,
    /// Node of the columns of each block, rising in a row.
    pub columns: Vec<usize>,
    /// First value of each block, and the number of values.
    pub offsets: Vec<usize>,
    pub values: Vec<f64>,
}

impl Blocks {
    /// A matrix of zeros with the pattern of `rows`: the columns of each row of blocks, rising.
    pub fn zeros(first: Vec<usize>, rows: &[Vec<usize>]) -> Self {
        let size = |node: usize| first[node + 1] - first[node];
        let (mut starts, mut columns, mut offsets) = (vec![0], Vec::new(), vec![0]);
        let mut end = 0;
        for (row, nodes) in rows.iter().enumerate() {
            for &column in nodes {
                columns.push(column);
                end += size(row) * size(column);
                offsets.push(end);
            }
            starts.push(columns.len());
        }
        Self {
            first,
            starts,
            columns,
            offsets,
            values: vec![0.0; end],
        }
    }

    pub fn nodes(&self) -> usize {
        self.starts.len() - 1
    }

    pub fn unknowns(&self) -> usize {
        self.first.last().copied().unwrap_or(0)
    }

    pub fn size(&self, node: usize) -> usize {
        self.first[node + 1] - self.first[node]
    }

    /// Numbers of the blocks of a row.
    pub fn row(&self, node: usize) -> std::ops::Range<usize> {
        self.starts[node]..self.starts[node + 1]
    }

    pub fn block(&self, number: usize) -> &[f64] {
        &self.values[self.offsets[number]..self.offsets[number + 1]]
    }

    pub fn block_mut(&mut self, number: usize) -> &mut [f64] {
        &mut self.values[self.offsets[number]..self.offsets[number + 1]]
    }

    /// The number of the block at a place, if it is stored.
    pub fn find(&self, row: usize, column: usize) -> Option<usize> {
        let range = self.row(row);
        let place = self.columns[range.clone()].binary_search(&column).ok()?;
        Some(range.start + place)
    }

    /// Adds the product of one row of blocks with a vector to `sum`, which has the size of the node.
    #[inline]
    pub fn add_row_product(&self, node: usize, vector: &[f64], sum: &mut [f64]) {
        for number in self.row(node) {
            let column = self.columns[number];
            let part = &vector[self.first[column]..self.first[column + 1]];
            if let (&[x, y, z], [a, b, c], &[p, q, r, s, t, u, v, w, o]) =
                (part, &mut *sum, self.block(number))
            {
                *a += p * x + q * y + r * z;
                *b += s * x + t * y + u * z;
                *c += v * x + w * y + o * z;
                continue;
            }
            for (values, sum) in self.block(number).chunks_exact(part.len()).zip(&mut *sum) {
                *sum += values.iter().zip(part).map(|(a, b)| a * b).sum::<f64>();
            }
        }
    }

    /// `out` = this matrix times `vector`.
    pub fn multiply(&self, vector: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for node in 0..self.nodes() {
            let range = self.first[node]..self.first[node + 1];
            self.add_row_product(node, vector, &mut out[range]);
        }
    }
}
