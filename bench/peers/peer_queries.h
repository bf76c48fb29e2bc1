// SPDX-License-Identifier: MIT
// peer_queries.h -- scree_peers queries: measures rays, moving shapes and overlaps in both engines.
#ifndef PEER_QUERIES_H
#define PEER_QUERIES_H

int queries_peers(int count, char** arguments);

#endif
