"""Exactly-once delivery in order: IDs, retransmission and flow control for the messages of one host.

- `window`: submits messages in order, keeps their state, and settles them by the answers that arrive
- `sequence_space`: the IDs of one session, and the messages that have them
- `retransmission`: which IDs are sent again, and when
- `loss_detection`: signs from which the loss of a frame follows
- `send_limit`: how many messages are in flight on a line that loses frames
- `round_trip`: the retransmission timeout from measured round trips
- `posted_writes`: writes without a response, which a fence confirms
- `constants`: durations and counts, the same for the clients of all languages
"""
