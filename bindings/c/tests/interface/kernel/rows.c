/* Reads rows of numbers and writes what tribos_kernel.h makes of them: `rows round|polygon f32|f64`. */
#include "tribos_kernel.h"
#include <stdio.h>

/* Of every row: twist, wrench, strength, radius or number of corners, length, mass, inertia, dt; then the pressure, or room
 * for eight corners. */
#define ROUND_IN 13
#define POLYGON_IN 28
/* Wrench, Jacobian, gauge, normal, projection, step; of polygons also that there is one, and the wrench once more. */
#define ROUND_OUT 27
#define POLYGON_OUT 31

#define FOUND(real) \
	w.x, w.y, w.torque, j.xx, j.xy, j.xn, j.yy, j.yn, j.nn, gauge, n.x, n.y, n.spin, p.wrench.x, p.wrench.y, \
		p.wrench.torque, p.normal.x, p.normal.y, p.normal.spin, (real)p.slides, s.twist.x, s.twist.y, \
		s.twist.spin, s.friction.x, s.friction.y, s.friction.torque, (real)s.is_at_rest

#define FUNCTIONS(real, fx) \
	static void round_##fx(const real *in, real *out) \
	{ \
		const int pressure = (int)in[12]; \
		const tribos_kernel_twist_##fx twist = { in[0], in[1], in[2] }; \
		const tribos_kernel_wrench_##fx push = { in[3], in[4], in[5] }; \
		const real strength = in[6], radius = in[7]; \
		const tribos_kernel_body_##fx body = { in[9], in[10] }; \
		const tribos_kernel_wrench_##fx w = tribos_kernel_round_wrench_##fx(pressure, twist, strength, radius); \
		const tribos_kernel_jacobian_##fx j = \
			tribos_kernel_round_jacobian_##fx(pressure, twist, strength, radius); \
		const real gauge = tribos_kernel_round_gauge_##fx(pressure, push, strength, radius); \
		const tribos_kernel_twist_##fx n = tribos_kernel_round_normal_##fx(pressure, push, radius); \
		const tribos_kernel_projection_##fx p = \
			tribos_kernel_round_project_##fx(pressure, push, strength, radius, in[8]); \
		const tribos_kernel_step_##fx s = \
			tribos_kernel_round_step_##fx(pressure, body, twist, push, strength, radius, in[11]); \
		const real found[ROUND_OUT] = { FOUND(real) }; \
		memcpy(out, found, sizeof found); \
	} \
	static void polygon_##fx(const real *in, real *out) \
	{ \
		const tribos_kernel_twist_##fx twist = { in[0], in[1], in[2] }; \
		const tribos_kernel_wrench_##fx push = { in[3], in[4], in[5] }; \
		const real strength = in[6]; \
		const tribos_kernel_body_##fx body = { in[9], in[10] }; \
		tribos_kernel_edge_##fx edges[8]; \
		tribos_kernel_polygon_##fx polygon; \
		memset(out, 0, POLYGON_OUT * sizeof *out); \
		if (tribos_kernel_polygon_prepare_##fx(in + 12, (int)in[7], edges, &polygon)) { \
			tribos_kernel_jacobian_##fx j; \
			const tribos_kernel_wrench_##fx w = \
				tribos_kernel_polygon_wrench_##fx(&polygon, edges, twist, strength); \
			const tribos_kernel_wrench_##fx v = \
				tribos_kernel_polygon_wrench_jacobian_##fx(&polygon, edges, twist, strength, &j); \
			const real gauge = tribos_kernel_polygon_gauge_##fx(&polygon, edges, push, strength); \
			const tribos_kernel_twist_##fx n = \
				tribos_kernel_polygon_normal_##fx(&polygon, edges, push, strength); \
			const tribos_kernel_projection_##fx p = \
				tribos_kernel_polygon_project_##fx(&polygon, edges, push, strength, in[8]); \
			const tribos_kernel_step_##fx s = \
				tribos_kernel_polygon_step_##fx(&polygon, edges, body, twist, push, strength, in[11]); \
			const real found[POLYGON_OUT] = { FOUND(real), 1, v.x, v.y, v.torque }; \
			memcpy(out, found, sizeof found); \
		} \
	} \
	static void all_##fx(int is_round) \
	{ \
		real in[POLYGON_IN], out[POLYGON_OUT]; \
		while (fread(in, sizeof *in, is_round ? ROUND_IN : POLYGON_IN, stdin) > 0) { \
			(is_round ? round_##fx : polygon_##fx)(in, out); \
			fwrite(out, sizeof *out, is_round ? ROUND_OUT : POLYGON_OUT, stdout); \
		} \
	}
FUNCTIONS(float, f32)
FUNCTIONS(double, f64)

int main(int argc, char **argv)
{
	const int is_round = argc > 1 && !strcmp(argv[1], "round");
	if (argc > 2 && !strcmp(argv[2], "f32"))
		all_f32(is_round);
	else
		all_f64(is_round);
	return 0;
}
