// SPDX-License-Identifier: MIT
// angle.h -- computes the angle of a rotation.
#ifndef ANGLE_H
#define ANGLE_H
#include "dialect/vec.h"

// rad: Returns the angle of a rotation, from -pi to pi (half a turn: pi), by the arctangent series for up to pi / 8.
INLINE Real vec_angle(Vec rotation)
{
	Real x = absolute(rotation.x), y = absolute(rotation.y), sum = splat(0.0f);
	Int steep = (y < x) == 0;
	Real t = blend(quotient(y, x), quotient(x, y), steep);
	Int large = t > splat(0.414f);
	Real base = only(splat(0.785398163f), large);
	t = blend(t, quotient(t - 1.0f, t + 1.0f), large);
	Real q = t * t;
	for (int k = 13; k >= 1; k -= 2)
		sum = splat(quotient(1.0f, (float)k)) - q * sum;
	Real angle = base + t * sum;
	angle = blend(angle, 1.57079633f - angle, steep);
	angle = blend(angle, 3.14159265f - angle, rotation.x < splat(0.0f));
	return blend(angle, -angle, rotation.y < splat(0.0f));
}

#endif
