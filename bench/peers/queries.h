// SPDX-License-Identifier: MIT
// queries.h -- scree_peers queries: rays, moving shapes and overlaps in both engines.
#ifndef QUERIES_H
#define QUERIES_H

int queries_peers(int count, char** arguments);

#endif
