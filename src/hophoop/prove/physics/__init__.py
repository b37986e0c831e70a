"""The equations, the mode rule and impacts of docs/model.md on balls."""
