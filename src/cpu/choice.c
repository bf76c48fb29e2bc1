// SPDX-License-Identifier: MIT
// choice.c -- whether the workers share a solve, or one worker does it alone.
#include "cpu/cpu.h"
#include "platform/processor.h"
#include <limits.h>

// A solve with more items per run than this is always shared.
#define ALWAYS_SHARED 2048
// The slower way is measured again after so many solves, times the square of the ratio of the times.
#define REST 32
// limit of that ratio, because a busy machine can make one way seem slow
#define MOST_SLOWER 8.0
// Solves in a row by a way that is measured. Only the last one counts: in the first one, other workers may have to wake.
#define TURN 2
// the first solves take turns: a single measurement may have been interrupted
#define FIRST_SOLVES (4 * TURN)

// The other way is measured again at times, less often the slower it was. A time longer than the last may be due to an
// interruption, so it is averaged in with a weight of a quarter.
void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains)
{
	Choice* c = &cpu->choice;
	double mean = items / count;
	bool open = mean + chains / count >= SOLVE_GRAIN && mean <= ALWAYS_SHARED, first = open && c->solves < FIRST_SOLVES;
	bool tries = open && !first && --c->rest < 0;
	bool counts = first ? c->solves % TURN == TURN - 1 : !tries || c->rest == -TURN;
	if (!open)
		c->shares = mean > ALWAYS_SHARED;
	else
		c->shares = first ? c->solves / TURN % 2 == 0 : (c->cost[1] < c->cost[0]) != tries;
	c->solves += first;
	double begin = processor_milliseconds();
	cpu_work(cpu, runs, count, c->shares ? SOLVE_GRAIN : INT_MAX);
	double cost = 1e6 * (processor_milliseconds() - begin) / items, *known = &c->cost[c->shares];
	if (!counts)
		return;
	*known = *known > 0 && cost > *known ? 0.75 * *known + 0.25 * cost : cost;
	if (tries)
	{
		double slower = c->cost[c->shares] / c->cost[!c->shares];
		slower = slower < MOST_SLOWER ? slower : MOST_SLOWER;
		c->rest = slower > 1 ? (int)(REST * slower * slower) : REST;
	}
}
