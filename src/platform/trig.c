// SPDX-License-Identifier: MIT
// trig.c -- computes sine, cosine and arc tangent on the host, by power series after an exact reduction of the angle.
//
// The reduction follows Mary Payne, Robert Hanek, Radian Reduction for Trigonometric Functions, 1983: a large angle is
// multiplied only by those digits of 1 / (2 pi) that affect the fraction of a turn.
#include "platform/trig.h"
#include "platform/processor.h"
#include "scree/scree.h"
#include <math.h>
#include <string.h>

// 1 / (2 pi) in words of 32 bits, after one word of zeros; the digits suffice for the largest float
static const uint32_t turn_digits[] = {0,          0x28be60db, 0x9391054a, 0x7f09d5f4,
                                       0x7d4d3770, 0x36d8a566, 0x4f10e410, 0x7f9458ea};

// Returns an angle minus its whole turns, in units of 2^-64 turns. angle: rad, at least 1/2.
static uint64_t turn_fraction(float angle)
{
	uint32_t bits;
	memcpy(&bits, &angle, sizeof bits);
	uint64_t mantissa = (bits & 0x7fffffu) | 0x800000u;
	int shift = (int)(bits >> 23 & 0xff) - 150 + 32;

	// three words of digits; earlier digits would add only whole turns
	uint32_t digits[3];
	for (int k = 0; k < 3; ++k)
	{
		const uint32_t* word = turn_digits + shift / 32 + k;
		uint64_t both = (uint64_t)word[0] << 32 | word[1];
		digits[k] = (uint32_t)(both >> (32 - shift % 32));
	}
	uint64_t low = mantissa * digits[2];
	uint64_t middle = mantissa * digits[1] + (low >> 32);
	uint64_t high = mantissa * digits[0] + (middle >> 32);
	return high << 32 | (middle & 0xffffffffu);
}

void sine_cosine(float angle, double* sine, double* cosine)
{
	float size = angle < 0.0f ? -angle : angle;
	double r = size;
	unsigned quadrant = 0;
	if (!isfinite(angle))
		r = angle - angle;
	else if (size > 0.78f)
	{
		uint64_t turn = turn_fraction(size);
		quadrant = (unsigned)((turn + (1ull << 61)) >> 62 & 3);
		r = (double)(int64_t)(turn - ((uint64_t)quadrant << 62)) * (2.0 * PI / 18446744073709551616.0);
	}

	// Taylor series, for r up to pi / 4
	double q = r * r;
	double s = 1.0 - q / 156.0;
	s = 1.0 - q / 110.0 * s;
	s = 1.0 - q / 72.0 * s;
	s = 1.0 - q / 42.0 * s;
	s = 1.0 - q / 20.0 * s;
	s = r * (1.0 - q / 6.0 * s);
	double c = 1.0 - q / 182.0;
	c = 1.0 - q / 132.0 * c;
	c = 1.0 - q / 90.0 * c;
	c = 1.0 - q / 56.0 * c;
	c = 1.0 - q / 30.0 * c;
	c = 1.0 - q / 12.0 * c;
	c = 1.0 - q / 2.0 * c;

	double turned_s = quadrant & 1 ? c : s, turned_c = quadrant & 1 ? s : c;
	if (quadrant == 2 || quadrant == 3)
		turned_s = -turned_s;
	if (quadrant == 1 || quadrant == 2)
		turned_c = -turned_c;
	*sine = angle < 0.0f ? -turned_s : turned_s;
	*cosine = turned_c;
}

double arc_tangent(double y, double x)
{
	double ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y;
	if (ax == 0.0 && ay == 0.0)
		return 0.0;

	// reduction to an angle of at most pi / 8, whose tangent is t
	double t = ay < ax ? ay / ax : ax / ay, base = 0.0;
	if (t > 0.414)
	{
		t = (t - 1.0) / (t + 1.0);
		base = PI / 4.0;
	}

	// Gregory's series of the arc tangent
	double q = t * t, sum = 0.0;
	for (int k = 23; k >= 1; k -= 2)
		sum = 1.0 / k - q * sum;
	double angle = base + t * sum;

	if (!(ay < ax))
		angle = PI / 2.0 - angle;
	if (x < 0.0)
		angle = PI - angle;
	return y < 0.0 ? -angle : angle;
}

// The results of these two functions are volatile, so that they are rounded before the mode of the caller returns: a
// compiler may move a conversion behind the call that sets the mode.
scree_rot scree_rot_make(float radians)
{
	FLOAT_MODE_HERE;
	double s, c;
	sine_cosine(radians, &s, &c);
	volatile float cosine = (float)c, sine = (float)s;
	return (scree_rot){cosine, sine};
}

float scree_rot_get_angle(scree_rot rotation)
{
	FLOAT_MODE_HERE;
	volatile float angle = (float)arc_tangent(rotation.s, rotation.c);
	return angle;
}
