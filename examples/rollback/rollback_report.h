// SPDX-License-Identifier: MIT
// rollback_report.h -- the results of a run, and their table.
#ifndef ROLLBACK_REPORT_H
#define ROLLBACK_REPORT_H
#include "rollback_exchange.h"

typedef struct
{
	int peer;
	bool good; // the whole game was played, and all hashes were compared and equal
	char device[128];
#define X(member, decimals, text) double member;
#include "rollback_report.def"
#undef X
} Report;

// Fills the numbers of a report.
void report_fill(Report* report, const Peer* peer);
// Prints a table with a column for each report, unless no frame was played.
void report_print(const Report* reports, int count);

#endif
