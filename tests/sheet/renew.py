"""`make sheets`: the sheets that are kept become those drawn now; of each that changed, a page shows what did."""

from __future__ import annotations

from goldens import FOLDER, compare, keep, show

from facescript.resolve.kinds.library import kind_names


def main() -> None:
    """Renews what differs by more than the tests allow, and leaves the rest as it is."""
    for kind in kind_names():
        found = compare(kind)
        if found.same:
            print(f"{found.told()}: kept as it is")
            continue
        page = show(found)
        keep(kind)
        print(f"{found.told()}: renewed; {page} shows before, after and difference")
    for path in FOLDER.glob("*.png"):
        if path.stem not in kind_names():
            path.unlink()
            print(f"{path.stem}: no such kind any more; removed")


if __name__ == "__main__":
    main()
