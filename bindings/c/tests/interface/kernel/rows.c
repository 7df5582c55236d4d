/* Reads rows of numbers and writes what tribos_kernel.h makes of them: `rows round|polygon f32|f64`. */
#include "tribos_kernel.h"
#include <stdio.h>

/* Of a round row: pressure, twist, wrench, strength, radius, length, mass, inertia, dt. */
#define ROUND_IN 13
#define ROUND_OUT 27
/* Of a polygon's row: twist, strength, number of corners, and room for eight of them. */
#define POLYGON_IN 21
#define POLYGON_OUT 13

#define FUNCTIONS(real, fx) \
	static void round_##fx(const real *in, real *out) \
	{ \
		const int pressure = (int)in[0]; \
		const tribos_kernel_twist_##fx twist = { in[1], in[2], in[3] }; \
		const tribos_kernel_wrench_##fx push = { in[4], in[5], in[6] }; \
		const real strength = in[7], radius = in[8]; \
		const tribos_kernel_body_##fx body = { in[10], in[11] }; \
		const tribos_kernel_wrench_##fx w = tribos_kernel_round_wrench_##fx(pressure, twist, strength, radius); \
		const tribos_kernel_jacobian_##fx j = \
			tribos_kernel_round_jacobian_##fx(pressure, twist, strength, radius); \
		const tribos_kernel_twist_##fx n = tribos_kernel_round_normal_##fx(pressure, push, radius); \
		const tribos_kernel_projection_##fx p = \
			tribos_kernel_round_project_##fx(pressure, push, strength, radius, in[9]); \
		const tribos_kernel_step_##fx s = \
			tribos_kernel_round_step_##fx(pressure, body, twist, push, strength, radius, in[12]); \
		const real found[ROUND_OUT] = { w.x, w.y, w.torque, j.xx, j.xy, j.xn, j.yy, j.yn, j.nn, \
			tribos_kernel_round_gauge_##fx(pressure, push, strength, radius), n.x, n.y, n.spin, \
			p.wrench.x, p.wrench.y, p.wrench.torque, p.normal.x, p.normal.y, p.normal.spin, (real)p.slides, \
			s.twist.x, s.twist.y, s.twist.spin, s.friction.x, s.friction.y, s.friction.torque, \
			(real)s.is_at_rest }; \
		memcpy(out, found, sizeof found); \
	} \
	static void polygon_##fx(const real *in, real *out) \
	{ \
		const tribos_kernel_twist_##fx twist = { in[0], in[1], in[2] }; \
		const int count = (int)in[4]; \
		tribos_kernel_edge_##fx edges[8]; \
		tribos_kernel_polygon_##fx polygon; \
		tribos_kernel_jacobian_##fx j; \
		tribos_kernel_wrench_##fx w, v; \
		int n; \
		for (n = 0; n < POLYGON_OUT; ++n) \
			out[n] = 0; \
		if (!tribos_kernel_polygon_prepare_##fx(in + 5, count, edges, &polygon)) \
			return; \
		w = tribos_kernel_polygon_wrench_##fx(&polygon, edges, count, twist, in[3]); \
		v = tribos_kernel_polygon_wrench_jacobian_##fx(&polygon, edges, count, twist, in[3], &j); \
		{ \
			const real found[POLYGON_OUT] = { 1, w.x, w.y, w.torque, v.x, v.y, v.torque, j.xx, j.xy, j.xn, j.yy, \
				j.yn, j.nn }; \
			memcpy(out, found, sizeof found); \
		} \
	} \
	static void all_##fx(int is_round) \
	{ \
		real in[POLYGON_IN], out[ROUND_OUT]; \
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
