//! Conversions between a structure of the header and the kernel's structure with the same fields.

/// Implements `From` both ways, field by field.
macro_rules! same_fields {
    ($header:ident, $kernel:ty { $($field:ident),* }) => {
        impl From<$header> for $kernel {
            #[inline(always)]
            fn from(from: $header) -> Self {
                Self { $($field: from.$field.into()),* }
            }
        }

        impl From<$kernel> for $header {
            #[inline(always)]
            fn from(from: $kernel) -> Self {
                Self { $($field: from.$field.into()),* }
            }
        }
    };
}

pub(crate) use same_fields;
