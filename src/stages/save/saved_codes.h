// SPDX-License-Identifier: MIT
// saved_codes.h -- declares the bits of a code, from which the manifold of a saved contact follows.
#ifndef SAVED_CODES_H
#define SAVED_CODES_H

// Bits of a code.
#define SAVED_WAY       3u // mask of SAVED_NO_POINTS and so on
#define SAVED_NO_POINTS 0u // no points
#define SAVED_EDGES     1u // the clipped edge `incident` of one shape on edge `reference` of the other
#define SAVED_COLLIDE   2u // result of collide without a largest separation
#define SAVED_SWAP      4u // the reference edge is that of shape b
#define SAVED_HIGH      8u // the first end of the clipped edge is a point
#define SAVED_LOW       16u
#define SAVED_REFERENCE 5 // position of the number of the reference edge, 3 bits
#define SAVED_INCIDENT  8 // position of that of the incident edge, 3 bits
#define SAVED_CODE_BITS 11

#endif
