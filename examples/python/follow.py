"""Follows a served map: says what becomes of it and of its daemon. Ends after some seconds without news.

``follow.py [NAME] [SECONDS]``
"""

import sys

import mapd


def main(name: str, patience: float) -> None:
    with mapd.Client(name) as client:
        print(client.map())
        events = client.events()
        while (event := events.wait(patience)) is not None:
            if isinstance(event, mapd.Generation):
                print("now", event.map)
            elif isinstance(event, mapd.DaemonGone):
                print("the daemon is gone; driving on with what is held")
            else:
                print(event)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "town", float(sys.argv[2]) if len(sys.argv) > 2 else 1.0)
