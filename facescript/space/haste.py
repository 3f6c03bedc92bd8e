"""Planned gaze shifts to warnings of those that are to take less time than eyes or head need."""

from __future__ import annotations

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostics
from facescript.space.plan import GazePlan
from facescript.space.reach import Scored
from facescript.text import Span


def haste(score: Scored, diagnostics: Diagnostics) -> None:
    """Warn of every `over` that eyes or head cannot follow, once a place in the script, with the worst case (FS607)."""
    worst: dict[Span, GazePlan] = {}
    for act in score.acts:
        for plan in act.plan:
            if plan.needs > (worst[act.span].needs if act.span in worst else 0.0):
                worst[act.span] = plan
    for span, plan in worst.items():
        part = "head" if plan.parts == "head only" else "eyes"
        needs, far = f"{plan.needs * 1000:.0f}ms", f"{plan.amplitude:.0f}deg"
        diagnostics.add(diagnose("FS607", span, part=part, needs=needs, far=far))
