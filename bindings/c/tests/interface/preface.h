/*
 * Tribos: coupled sliding and spinning friction. Generated from the Rust source; do not edit.
 *
 * No heap, no global state, no panic. Everything exists in double (_f64) and in single precision
 * (_f32), with the same meaning. Units are any consistent set.
 *
 * Every function returns a tribos_status. If it is not TRIBOS_STATUS_OK, the results are left as
 * they were. Every call validates its parameters, with one or two comparisons each; motions, loads
 * and states are never refused: NaN in gives NaN out.
 *
 * A null pointer is refused. Every other pointer must point to memory of its type, aligned and, for
 * arguments, initialised; an array must hold as many elements as its count says and must not
 * overlap the results. No pointer is kept after the call, except that a polygon names the memory of its
 * edges. Functions may be called from any thread and from interrupts.
 *
 * The floating-point unit must round to nearest and keep subnormal numbers, as it does by default:
 * do not link with -ffast-math.
 */
