# SPDX-License-Identifier: Apache-2.0
"""Studies on a Dask cluster: many designs of one model, each remeshed from a near one.

    from distributed import Client
    from remesh_client.dask import map_designs
    designs = [{"hole_radius": r, "stiffener": w} for r in (8, 9, 10) for w in (6, 8, 10)]
    futures = map_designs(Client("tcp://scheduler:8786"), base, designs)
    volumes = [future.result().figures["volume"] for future in futures]

Beside each worker runs a daemon; all daemons share a tier. The time of an edit goes with the nodes
that are made anew, and those go with the parameters that change. So a plan is made before anything
runs: a tree of least predicted cost over the base and all designs, along whose edges few and cheap
parameters change. A mesh depends on what it was remeshed from; since the plan depends on the base,
the designs and the options of `map_designs` alone, never on who is free, all ids and meshes are the
same whatever the number of workers. Dask gives a task to the worker that has the result of its
parent, whose daemon has the mesh in memory, and to another one that is idle.
"""
from __future__ import annotations

import itertools
import os
import threading
import time
from dataclasses import dataclass, replace
from typing import Any, Literal, Mapping, NamedTuple, Sequence, Union

from distributed import Client, Future, get_worker

from remesh_client import _requests
from remesh_client._connection import addresses_or_default
from remesh_client._search import Search
from remesh_client.daemon import Daemon, connect
from remesh_client.edits import Value
from remesh_client.errors import Busy, Cancelled, NotFound, RemeshError, Unavailable
from remesh_client.part import Part, in_several
from remesh_client.studies import Plan, figures_of, plan_designs, tried_values, values_in
from remesh_client.v1 import revision_pb2

__all__ = ["DesignResult", "Plan", "learn_shares", "map_designs", "open_part", "plan_designs"]

_PASSING = (Unavailable, Busy, Cancelled, NotFound)  # the tier may not have its parent yet
_WAIT = 1.0  # s before another try


@dataclass(frozen=True)
class DesignResult:
    """What a design's future gives; its mesh stays at the daemons (`open_part`).

    revision: id. parent: id of the revision that it was remeshed from. way: `LOCAL`, `MORPHED`, ...
    (report.proto). figures: all numbers of its Report by name, `nodes`, `nodes_kept`, `volume`,
    `quality.dihedral_min`. warnings: their codes. seconds: that the daemon computed for it; 0 where
    the base or another design has the same values. waited: s between the worker's request and its
    answer. replica: address of the daemon that answered.
    """

    revision: str
    parent: str
    way: str
    figures: Mapping[str, float]
    warnings: tuple[str, ...]
    seconds: float
    waited: float
    replica: str


class _Site(NamedTuple):
    """How workers reach daemons: addresses beside those of REMESH_ADDRESS, arguments of connect."""

    addresses: tuple[str, ...]
    access: tuple[tuple[str, Any], ...]


class _Step(NamedTuple):
    """One design to make: of its parent, or of the base where that failed."""

    base: str
    change: Mapping[str, Value]
    from_base: Mapping[str, Value]
    timeout: float | None


_Outcome = Union[DesignResult, RemeshError]  # an error is returned, so that children see it


def map_designs(client: Client, base: Part | str, designs: Sequence[Mapping[str, Value]], *,
                addresses: Sequence[str] = (), depth: int = 8,
                shares: Mapping[str, float] | None = None, timeout: float | None = None,
                retries: int = 3, **access: Any) -> list[Future]:
    """Remeshes all designs on a cluster; futures of a DesignResult each, in the order of designs.

    client: a synchronous one. base: a revision that all daemons know, or its id; its options hold
    for all. designs: values by parameter, `{"radius": 8, "rib.width": 3}`; what one leaves out is
    the base's. No revision joins a design of the daemon. addresses: of all daemons. A worker asks
    the first address of its own REMESH_ADDRESS; where that is not set, the one of `addresses` that
    a hash of the worker's name picks; where the one asked is not available, the others. depth:
    most edits between the base and a design; more may save time
    but leave less to do side by side. shares: as of `plan_designs`; default: learned by
    `learn_shares`, for which this waits. timeout: s for each edit. retries: of what failed because
    no daemon was available or those there were busy. access: of rc.connect, `patience`, `tls_ca`,
    ...; files are the workers'.

    A model that cannot be meshed or time that is up is the exception of that design's future, a
    RemeshError; what was to be made of it is made of the base. (So ids depend on time only where a
    timeout passes.) A design for which no daemon can be had fails with Unavailable or Busy, and
    with it what was to be made of it; called again, this makes what is missing, for the daemons
    have the rest. The tasks of a worker that is lost are done by others.

    Raises NotFound for the base, KeyError for a parameter that it has not, ValueError for a depth
    below 1, Unavailable; waits for a first worker where there is none.
    """
    root, site = _id(base), _Site(tuple(addresses), tuple(sorted(access.items())))
    values = _base_values(client, root, designs, site, retries)
    if shares is None:
        shares = learn_shares(client, base, designs, addresses=addresses, timeout=timeout,
                              retries=retries, **access)
    plan = plan_designs(values, designs, depth=depth, shares=shares)
    outcomes: dict[int, Future] = {}
    for design in plan.order:
        step = _Step(root, plan.changes[design], plan.from_base[design], timeout)
        outcomes[design] = _submit(client, _remesh, step, outcomes.get(plan.parents[design]), site,
                                   retries=retries)
    return [_submit(client, _told, outcomes[design]) for design in range(len(designs))]


def learn_shares(client: Client, base: Part | str, designs: Sequence[Mapping[str, Value]], *,
                 measure: Literal["nodes", "seconds"] = "nodes", addresses: Sequence[str] = (),
                 timeout: float | None = None, retries: int = 3,
                 **access: Any) -> dict[str, float]:
    """What a change of each parameter costs, for `plan_designs`.

    Of every parameter that varies one edit of the base is made, to the value that most designs
    have. A parameter whose edit fails is left out; nothing is made where fewer than two vary.
    measure: `nodes`: the share of nodes that are not kept, the same every time; `seconds`: of
    computing, better where the clean-up of a coarse mesh takes most of it, but another number each
    time: keep them with the study and give them as `shares` whenever it is made again. Other
    arguments and errors: as of `map_designs`.
    """
    root, site = _id(base), _Site(tuple(addresses), tuple(sorted(access.items())))
    tried = tried_values(_base_values(client, root, designs, site, retries), designs)
    if len(tried) < 2:
        return {}
    steps = [_Step(root, change, change, timeout) for change in tried]
    found = [future.result() for future in [
        _submit(client, _remesh, step, None, site, retries=retries) for step in steps]]
    return {name: (made.seconds if measure == "seconds"
                   else 1.0 - made.figures["nodes_kept"] / made.figures["nodes"])
            for change, made in zip(tried, found) if isinstance(made, DesignResult)
            for name in change}


def open_part(made: DesignResult, *, addresses: Sequence[str] = (), **access: Any) -> Part:
    """The Part of a result, for tasks that need its mesh; call it in a task.

    Arguments: as of `map_designs`. The mesh comes to the worker when it is asked for. Raises
    RemeshError.
    """
    daemon, route = _connection(_Site(tuple(addresses), tuple(sorted(access.items()))))
    return _opened(daemon, made.revision, route)


def _id(base: Part | str) -> str:
    return base if isinstance(base, str) else base.revision


def _submit(client: Any, *task: Any, **how: Any) -> Any:
    """A task, made again where it is asked for again: daemons answer from their cache."""
    return client.submit(*task, pure=False, **how)


def _base_values(client: Client, root: str, designs: Sequence[Mapping[str, Value]], site: _Site,
                 retries: int) -> dict[str, Value]:
    names = sorted({name for design in designs for name in design})
    values: dict[str, Value] = _submit(client, _values, root, names, site,
                                       retries=retries).result()
    return values


# What follows runs on workers.


def _remesh(step: _Step, parent: _Outcome | None, site: _Site) -> _Outcome:
    """Raises what another try may mend, after a while; other errors are its outcome."""
    above = parent if isinstance(parent, DesignResult) else None
    revision = above.revision if above is not None else step.base
    change = step.change if above is not None or parent is None else step.from_base
    if above is not None and not change:
        return replace(above, seconds=0.0, waited=0.0)
    daemon, route = _connection(site)
    begun = time.monotonic()
    try:
        part = (_edited(daemon, revision, change, step.timeout, route) if change
                else _opened(daemon, revision, route))
    except _PASSING as why:
        time.sleep(why.retry_after or _WAIT)
        raise
    except RemeshError as why:
        return why
    seconds = part.report.seconds.total if change else 0.0
    return DesignResult(part.revision, part.parent, part.report.Way.Name(part.report.way)[4:],
                        figures_of(part.report), tuple(each.code for each in part.warnings), seconds,
                        time.monotonic() - begun, _replica(daemon, part, route))


def _told(outcome: _Outcome) -> DesignResult:
    if isinstance(outcome, RemeshError):
        raise outcome
    return outcome


def _values(root: str, names: Sequence[str], site: _Site) -> dict[str, Value]:
    """The base's values of parameters, of the model or of features (`rib.width`)."""
    daemon, route = _connection(site)
    return values_in(daemon._document(root, route), names)


class _Thread(threading.local):
    """What each thread of a worker keeps: a stream is answered in order, so none share one."""

    def __init__(self) -> None:
        self.connections: dict[tuple[Any, ...], tuple[Daemon, str]] = {}


_thread = _Thread()


def _connection(site: _Site) -> tuple[Daemon, str]:
    """This worker's, and the route by which its own replica is asked first."""
    own = [each.strip() for each in os.environ.get("REMESH_ADDRESS", "").split(",")]
    addresses = addresses_or_default(list(dict.fromkeys(filter(None, [*own, *site.addresses])))
                                     or None)
    name = str(get_worker().address)
    key = (tuple(addresses), site.access, name)
    if key not in _thread.connections:
        daemon = connect(addresses, **dict(site.access))
        routes = (f"{name}/{number}" for number in itertools.count())
        _thread.connections[key] = daemon, next(
            route for route in routes
            if not any(own) or _first(daemon, route) == addresses[0])
    return _thread.connections[key]


def _edited(daemon: Daemon, revision: str, change: Mapping[str, Value], timeout: float | None,
            route: str) -> Part:
    return daemon._make(_requests.edit_of(revision, [change], {}, {}, file=False, with_mesh=False,
                                          content=None, on_progress=None, route=route), timeout)


def _opened(daemon: Daemon, revision: str, route: str) -> Part:
    reply = daemon._ask("GetRevision", revision_pb2.GetRevisionRequest(revision=revision), route)
    return Part(daemon, reply.revision, reply.report, durable=reply.durable, route=route,
                in_several=in_several(revision, reply))


def _replica(daemon: Daemon, part: Part, route: str) -> str:
    """The address of the one that answered."""
    carrier = part._exchange.carrier if part._exchange is not None else None
    return next((replica.address for replica in daemon._farm.replicas
                 if replica.stream is carrier), _first(daemon, route))


def _first(daemon: Daemon, route: str) -> str:
    """The address of the replica that is asked first."""
    return Search(daemon._farm, route).replica().address
