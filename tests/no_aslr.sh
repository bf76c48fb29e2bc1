#!/usr/bin/env bash
# no_aslr.sh -- no_aslr.sh COMMAND...: runs the command at fixed addresses if the system allows it. The thread sanitizer's runtime
# finds no room for its shadow memory if the kernel randomizes addresses by more than 28 bits.
setarch -R true 2>/dev/null && exec setarch -R "$@"
exec "$@"
