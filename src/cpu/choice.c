// SPDX-License-Identifier: MIT
// choice.c -- whether the workers share a solve, or one worker does it alone.
#include "cpu/cpu.h"
#include "platform/processor.h"
#include <limits.h>

// A solve with more items per run than this is always shared.
#define ALWAYS_SHARED 2048
// The slower way is measured again after so many solves, times the square of the ratio of the times.
#define REST 64
// limit of that ratio, because a busy machine can make one way seem slow
#define MOST_SLOWER 4.0
// Solves in a row by a way that is measured. The fastest one but the first counts: any may be interrupted, and in the first one other
// workers may have to wake.
#define TURN 4
// the first solves take turns
#define FIRST_SOLVES (4 * TURN)

// The other way is measured again at times, less often the slower it was. A time longer than the last may be due to an
// interruption, so it is averaged in with a weight of a quarter.
void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains)
{
	Choice* c = &cpu->choice;
	double mean = items / count;
	bool open = mean + chains / count >= SOLVE_GRAIN && mean <= ALWAYS_SHARED, first = open && c->solves < FIRST_SOLVES;
	bool tries = open && !first && --c->rest < 0;
	int turn = first ? c->solves % TURN : tries ? -1 - c->rest : TURN - 1;
	if (!open)
		c->shares = mean > ALWAYS_SHARED;
	else
		c->shares = first ? c->solves / TURN % 2 == 0 : (c->cost[1] < c->cost[0]) != tries;
	c->solves += first;
	double begin = processor_milliseconds();
	cpu_work(cpu, runs, count, c->shares ? SOLVE_GRAIN : INT_MAX);
	double cost = 1e6 * (processor_milliseconds() - begin) / items, *known = &c->cost[c->shares];
	bool begins = turn <= 1 || !(first || tries);
	c->least = begins || cost < c->least ? cost : c->least;
	if (turn < TURN - 1)
		return;
	cost = c->least;
	*known = *known > 0 && cost > *known ? 0.75 * *known + 0.25 * cost : cost;
	if (tries)
	{
		double slower = c->cost[c->shares] / c->cost[!c->shares];
		slower = slower < MOST_SLOWER ? slower : MOST_SLOWER;
		c->rest = slower > 1 ? (int)(REST * slower * slower) : REST;
	}
}
