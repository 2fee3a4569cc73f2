"""The runtimes of a link, which run its coroutines: asyncio, the calling thread of blocking code, and trio.

- `runtime`: the interface that a link needs, and its implementation for asyncio
- `calling_thread`: blocking code; the thread that calls runs the coroutine
- `trio_runtime`: tasks of trio
- `waiter`, `timers`: futures and timers for the last two
- `loop_thread`: an event loop in a thread of its own, for a medium that needs one
- `synchronisation`: locks and callbacks that work in all three
"""
