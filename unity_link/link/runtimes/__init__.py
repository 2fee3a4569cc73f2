"""What runs the coroutines of a link: an event loop of asyncio, the calling thread, or tasks of trio.

- `runtime`: what a link asks of whatever runs it, and that of asyncio
- `calling_thread`: blocking code; the thread that calls runs the coroutine
- `trio_runtime`: tasks of trio
- `waiter`, `timers`: futures and timers for the last two
- `loop_thread`: an event loop in a thread of its own, for a medium that needs one
- `synchronisation`: locks and callbacks that work in all three
"""
