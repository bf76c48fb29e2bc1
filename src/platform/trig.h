// SPDX-License-Identifier: MIT
// trig.h -- sine, cosine and arc tangent on the host, from + - * / alone, so that every machine has the same bits.
#ifndef TRIG_H
#define TRIG_H

#define PI 3.14159265358979323846

// Of any finite angle, in radians; error below 1e-12. NaN for what is not finite.
void sine_cosine(float angle, double* sine, double* cosine);

// The angle of (x, y), in [-pi, pi]; error below 1e-10. 0 for (0, 0).
double arc_tangent(double y, double x);

#endif
