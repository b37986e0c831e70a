"""Why a change of the source cannot be seen: by module, function, the line as it stands and as it is with the change."""

from mutations_explained import files, physics, rigid, rigid_panels, several

EXPLAINED = {
    key: reason
    for room in (physics, rigid, rigid_panels, files, several)
    for reason, keys in room.REASONS.items()
    for key in keys
}
