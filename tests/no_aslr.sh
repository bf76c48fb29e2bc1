#!/usr/bin/env bash
# no_aslr.sh -- no_aslr.sh COMMAND...: runs it at fixed addresses where that is allowed. The thread sanitizer's runtime
# finds no room for its shadow memory on kernels that randomize addresses by more than 28 bits.
setarch -R true 2>/dev/null && exec setarch -R "$@"
exec "$@"
