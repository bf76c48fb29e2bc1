// SPDX-License-Identifier: MIT
// rollback_report.c -- collects the results of a run, and prints their table.
#include "rollback_report.h"
#include <math.h>
#include <stdio.h>

void report_fill(Report* report, const Peer* peer)
{
	const SessionCounts* counts = &peer->session.counts;
	const BadNetwork* network = &peer->network;
	double simulated = fmax(peer->session.frame + counts->repeated, 1.0), rollbacks = fmax(counts->rollbacks, 1.0);
	report->frames = peer->session.frame;
	report->confirmed = session_get_confirmed(&peer->session);
	report->rollbacks = counts->rollbacks;
	report->longest_rollback = counts->longest_rollback;
	report->repeated = counts->repeated;
	report->stalls = counts->stalls;
	report->hashes = counts->hashes;
	report->differences = peer->session.different >= 0;
	report->ahead = peer->ahead_sum / fmax(peer->ticks, 1.0);
	report->sent = network->sent;
	report->lost = network->lost;
	report->received = peer->received;
	report->overtaken = peer->overtaken;
	report->ignored = peer->damaged + peer->link->strangers;
	report->packet_bytes = network->bytes / fmax(network->sent, 1.0);
	double seconds = peer_time(peer) - peer->begun;
	report->seconds = seconds / peer->options->speed;
	report->packet_rate = 1e-3 * (network->bytes + HEADER_BYTES * network->sent) / fmax(seconds, 1e-9);
	report->rollback_ms = 1e3 * counts->rollback_time / rollbacks;
	report->worst_rollback_ms = 1e3 * counts->worst_rollback_time;
	report->step_ms = 1e3 * counts->step_time / simulated;
	report->save_ms = 1e3 * counts->save_time / simulated;
	report->hash_ms = 1e3 * counts->hash_time / simulated;
}

void report_print(const Report* reports, int count)
{
	bool played = false;
	for (int k = 0; k < count; ++k)
		played |= reports[k].frames > 0.0;
	if (!played)
		return;
	printf("\n%-46s", "");
	for (int k = 0; k < count; ++k)
		printf("%11s %d", "peer", reports[k].peer);
	printf("\n%-46s", "device");
	for (int k = 0; k < count; ++k)
		printf(" %12.12s", reports[k].device);
#define X(member, decimals, text)   \
	printf("\n%-46s", text);        \
	for (int k = 0; k < count; ++k) \
		printf("%13.*f", decimals, reports[k].member);
#include "rollback_report.def"
#undef X
	printf("\n");
}
