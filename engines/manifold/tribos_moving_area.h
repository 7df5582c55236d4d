/*
 * Tribos: the contact area of a manifold from step to step.
 *
 * An engine clips the same polygon in every step while a body slides and turns on another. Its lever and the tensors in
 * a frame of its own stay the same then: the area is recognised, moved and turned, and computed anew only if the polygon
 * has changed. C99, C++11 and later. MIT OR Apache-2.0.
 */
#pragma once

#include "tribos_manifold_friction.h"

/* Symmetric tensors are xx, xy, yy. */
typedef struct tribos_moving_area {
	tribos_contact_area_f32 area; /* in the frame of the corners */
	/* The tensors in the frame whose first axis points from the centre to the first corner. */
	float own_spinning[3], own_slipping[3];
	/* By what the polygon is recognised: twice its area, <r2> about the centre, r2 of the first corner; 0 corners if
	 * there is no polygon. */
	float twice, polar, first;
	int count;
	/* Whether the direction of slip matters: 0 for squares, disks and regular polygons. */
	int directed;
} tribos_moving_area;

/* Two polygons are the same if these measures agree to this fraction. */
#define TRIBOS_SAME_POLYGON 1.0e-4f
/* Polygons with less than this area over the square of their size are lines. */
#define TRIBOS_LINE 1.0e-4f

/* Components of tensors that differ by less than this fraction of them are the same. */
#define TRIBOS_ISOTROPIC 1.0e-2f

/* Whether a tensor depends on the direction. */
TRIBOS_FN int tribos_is_directed(const float tensor[3])
{
	float limit = 0.5f * TRIBOS_ISOTROPIC * (tensor[0] + tensor[2]);
	return fabsf(tensor[0] - tensor[2]) > limit || fabsf(2.0f * tensor[1]) > limit;
}

/* The tensor of a frame whose first axis is (c, s), in the outer frame. */
TRIBOS_FN void tribos_turn_tensor(const float own[3], float c, float s, float out[3])
{
	float mean = 0.5f * (own[0] + own[2]), half = 0.5f * (own[0] - own[2]);
	float c2 = (c - s) * (c + s), s2 = 2.0f * c * s, along = c2 * half - s2 * own[1];
	out[0] = mean + along;
	out[1] = s2 * half + c2 * own[1];
	out[2] = mean - along;
}

/* Sets the area from `count` corners (x, y in turn) in m. 0 if they bound no area: the old one is forgotten then. */
TRIBOS_FN int tribos_moving_area_set(tribos_moving_area *moving, const float *corners, int count)
{
	float twice = 0.0f, cx = 0.0f, cy = 0.0f, polar = 0.0f, inverse, first, c = 1.0f, s = 0.0f;
	int i;
	for (i = 1; i + 1 < count; ++i) {
		float ax = corners[2 * i] - corners[0], ay = corners[2 * i + 1] - corners[1];
		float bx = corners[2 * i + 2] - corners[0], by = corners[2 * i + 3] - corners[1];
		float cross = ax * by - ay * bx, mx = ax + bx, my = ay + by;
		twice += cross;
		cx += cross * mx;
		cy += cross * my;
		polar += cross * ((ax * ax + ay * ay) + (bx * bx + by * by) + (mx * mx + my * my));
	}
	if (count < 3 || twice * twice <= 2.0f * TRIBOS_LINE * fabsf(polar)) {
		moving->count = 0;
		return 0;
	}
	inverse = 1.0f / twice;
	cx *= inverse / 3.0f;
	cy *= inverse / 3.0f;
	first = cx * cx + cy * cy;
	polar = polar * inverse / 12.0f - first;
	if (first > 0.0f) {
		float scale = -1.0f / sqrtf(first);
		c = cx * scale;
		s = cy * scale;
	}
	if (count == moving->count && fabsf(twice - moving->twice) <= TRIBOS_SAME_POLYGON * fabsf(twice) &&
		fabsf(polar - moving->polar) <= TRIBOS_SAME_POLYGON * polar &&
		fabsf(first - moving->first) <= TRIBOS_SAME_POLYGON * polar) {
		moving->area.centre[0] = corners[0] + cx;
		moving->area.centre[1] = corners[1] + cy;
		if (moving->directed) {
			tribos_turn_tensor(moving->own_spinning, c, s, moving->area.spinning);
			tribos_turn_tensor(moving->own_slipping, c, s, moving->area.slipping);
		}
		return 1;
	}
	moving->area = tribos_contact_area(corners, count);
	tribos_turn_tensor(moving->area.spinning, c, -s, moving->own_spinning);
	tribos_turn_tensor(moving->area.slipping, c, -s, moving->own_slipping);
	moving->directed = tribos_is_directed(moving->own_spinning) || tribos_is_directed(moving->own_slipping);
	moving->twice = twice;
	moving->polar = polar;
	moving->first = first;
	moving->count = count;
	return 1;
}
