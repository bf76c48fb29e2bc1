// SPDX-License-Identifier: MIT
// choice.c -- chooses by measurements whether the workers share a solve, or one worker executes it.
#include "cpu/cpu.h"
#include "platform/processor.h"
#include <limits.h>

#define ALWAYS_SHARED 2048 // a solve with more items per run than this is always shared
// REST times the square of (slower time / faster time): number of solves until the slower method is measured again
#define REST        64
#define MOST_SLOWER 4.0 // limit of (slower time / faster time): a busy machine can make one method seem slow
// Solves in a measurement. The time of the fastest counts, because any solve may be interrupted; the first solve, which
// wakes the workers, does not count.
#define TURN        4
#define FIRST_TURNS 4 // number of measurements at the start, in which the two methods alternate

// Adds the cost of a solve, in ms per item, to the measurement, and chooses the method of the next solve. A cost higher
// than the stored cost may be due to an interruption, so it has a weight of a quarter. The other method is measured
// again after REST solves, or later if it was slower.
static void count_cost(Choice* c, double cost)
{
	bool first = c->turns < FIRST_TURNS, measures = first || c->tries;
	c->least = !measures || c->tried <= 1 || cost < c->least ? cost : c->least;
	if (measures && ++c->tried < TURN)
		return;
	double* known = &c->cost[c->shares];
	*known = *known > 0 && c->least > *known ? 0.75 * *known + 0.25 * c->least : c->least;
	c->tried = 0;
	c->turns += first;
	if (c->tries)
	{
		double slower = c->cost[c->shares] / c->cost[!c->shares];
		slower = slower < MOST_SLOWER ? slower : MOST_SLOWER;
		c->rest = slower > 1 ? (int)(REST * slower * slower) : REST;
	}
	c->tries = !measures && --c->rest < 0;
	c->shares = c->turns < FIRST_TURNS ? c->turns % 2 == 0 : (c->cost[1] < c->cost[0]) != c->tries;
}

void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains)
{
	Choice* c = &cpu->choice;
	double mean = items / count;
	bool open = mean + chains / count >= SOLVE_GRAIN && mean <= ALWAYS_SHARED;
	double begin = processor_milliseconds();
	cpu->shares = open ? c->shares : mean > ALWAYS_SHARED;
	cpu_work(cpu, runs, count, cpu->shares ? SOLVE_GRAIN : INT_MAX);
	if (open)
		count_cost(c, (processor_milliseconds() - begin) / items);
}
